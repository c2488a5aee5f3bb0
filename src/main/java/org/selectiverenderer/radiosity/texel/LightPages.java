package org.selectiverenderer.radiosity.texel;

import java.util.List;
import org.selectiverenderer.radiosity.atlas.Atlas;

/**
 * Irradiance on the pages of an atlas.
 *
 * @param irradiance by page: r, g, b per texel, lx, in the order of {@link
 *     org.selectiverenderer.radiosity.atlas.TexelMap}; gutters hold what the nearest texel of a
 *     chart has
 * @param complete whether every texel was gathered; if not, the rest has the patches' own values
 * @param rays cast
 * @param noise that is left
 */
public record LightPages(
    Atlas atlas, List<float[]> irradiance, boolean complete, long rays, TexelNoise noise) {

  /** Of light whose noise is not known, or that has none. */
  public LightPages(Atlas atlas, List<float[]> irradiance, boolean complete, long rays) {
    this(atlas, irradiance, complete, rays, TexelNoise.NONE);
  }
}
