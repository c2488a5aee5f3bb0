package org.selectiverenderer.radiosity;

import java.util.List;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.texel.TexelNoiseStatistics;

/**
 * Summary of the lightmaps that were written: their number, sizes, texel densities and noise.
 *
 * @param files number of image files
 * @param bytes size of all image files together
 * @param texels number of texels of all pages, gutters included
 * @param leastPerMetre lowest mean texel density of a body, texels per metre; 0 if no body has
 *     texels
 * @param mostPerMetre highest mean texel density of a body, texels per metre
 * @param multiplied number of shapes whose own texture stays and is multiplied by the lightmap
 * @param shining number of shapes that keep their specular highlights
 * @param noise statistics of the Monte Carlo noise that is left in the light
 */
public record LightmapReport(
    int files,
    long bytes,
    long texels,
    double leastPerMetre,
    double mostPerMetre,
    int multiplied,
    int shining,
    TexelNoiseStatistics noise) {

  static LightmapReport of(LightmappedScene lit, List<Integer> bytes, int multiplied, int shining) {
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (int i = 0; i < lit.scene().bodies().size(); i++) {
      double density = perMetre(lit, i);
      if (density > 0) {
        least = Math.min(least, density);
        most = Math.max(most, density);
      }
    }
    return new LightmapReport(
        bytes.size(),
        bytes.stream().mapToLong(Integer::longValue).sum(),
        lit.atlas().texels(),
        most > 0 ? least : 0,
        most,
        multiplied,
        shining,
        lit.pages().noise());
  }

  private static double perMetre(LightmappedScene lit, int number) {
    Atlas.Layout layout = lit.atlas().layouts().get(number);
    if (layout.page() == AtlasPage.NONE) {
      return 0;
    }
    Body body = lit.scene().bodies().get(number);
    double[] normal = new double[3];
    double surface = 0;
    double picture = 0;
    for (int i = 0; i < body.triangles(); i++) {
      surface += lit.scene().triangles().normal(body.firstTriangle() + i, normal);
      float[] st = layout.st();
      int at = 6 * i;
      double cross =
          ((double) st[at + 2] - st[at]) * (st[at + 5] - st[at + 1])
              - ((double) st[at + 3] - st[at + 1]) * (st[at + 4] - st[at]);
      picture += Math.abs(cross) / 2;
    }
    AtlasPage page = lit.atlas().pages().get(layout.page());
    return surface > 0 ? Math.sqrt(picture * page.texels() / surface) : 0;
  }
}
