package org.selectiverenderer.radiosity.texel;

import java.util.List;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;

/**
 * The irradiance at the texels of an atlas's pages.
 *
 * @param irradiance by page: r, g, b per texel, lx, in the order of {@link
 *     org.selectiverenderer.radiosity.atlas.AtlasPage}; gutters have the value of the nearest texel
 *     of a chart
 * @param complete whether every texel was gathered; if not, the rest has the values of the patches
 * @param rays number of rays cast
 * @param noise statistics of the noise that is left
 */
public record IrradianceAtlas(
    Atlas atlas,
    List<float[]> irradiance,
    boolean complete,
    long rays,
    TexelNoiseStatistics noise) {

  /** Creates pages without noise statistics. */
  public IrradianceAtlas(Atlas atlas, List<float[]> irradiance, boolean complete, long rays) {
    this(atlas, irradiance, complete, rays, TexelNoiseStatistics.NONE);
  }

  /**
   * Interpolates the irradiance bilinearly at a point of a page, as a browser draws it.
   *
   * @param s texture coordinate from 0 to 1, and so {@code t}
   * @param out receives r, g, b, lx
   */
  public void at(int page, double s, double t, double[] out) {
    AtlasPage map = atlas.pages().get(page);
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
