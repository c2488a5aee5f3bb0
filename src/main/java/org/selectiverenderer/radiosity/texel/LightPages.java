package org.selectiverenderer.radiosity.texel;

import java.util.List;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.TexelMap;

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

  /**
   * The irradiance at a place of a page, between the four texels around it, as it will be drawn.
   *
   * @param s from 0 to 1, with {@code t} the place
   * @param out gets r, g, b, lx
   */
  public void at(int page, double s, double t, double[] out) {
    TexelMap map = atlas.pages().get(page);
    double x = Math.max(0, Math.min(map.width() - 1, s * map.width() - 0.5));
    double y = Math.max(0, Math.min(map.height() - 1, t * map.height() - 0.5));
    int left = (int) x;
    int bottom = (int) y;
    int right = Math.min(map.width() - 1, left + 1);
    int top = Math.min(map.height() - 1, bottom + 1);
    float[] all = irradiance.get(page);
    for (int c = 0; c < 3; c++) {
      double below =
          between(
              all[3 * (bottom * map.width() + left) + c],
              all[3 * (bottom * map.width() + right) + c],
              x - left);
      double above =
          between(
              all[3 * (top * map.width() + left) + c],
              all[3 * (top * map.width() + right) + c],
              x - left);
      out[c] = between(below, above, y - bottom);
    }
  }

  private static double between(double a, double b, double share) {
    return a + share * (b - a);
  }
}
