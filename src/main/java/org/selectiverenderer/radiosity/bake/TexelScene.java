package org.selectiverenderer.radiosity.bake;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.texel.LightPages;

/**
 * A scene with its light in pictures.
 *
 * @param divided facets of bodies that are written with more polygons than they have, by body
 * @param curve makes colours of the light
 * @param rays cast in all
 */
public record TexelScene(
    LightScene scene,
    LightPages pages,
    Map<Integer, List<Facet>> divided,
    Solution solution,
    ToneCurve curve,
    long rays)
    implements Lit {

  public Atlas atlas() {
    return pages.atlas();
  }

  /**
   * The irradiance of the texel at a place of a body, lx; none where it has no page.
   *
   * @param triangle of the body
   * @param u weight of its second corner
   * @param v weight of its third corner
   * @param out gets r, g, b
   */
  public void irradiance(int body, int triangle, double u, double v, double[] out) {
    Atlas.Layout layout = atlas().layouts().get(body);
    Arrays.fill(out, 0);
    if (layout.page() == TexelMap.NONE) {
      return;
    }
    TexelMap page = atlas().pages().get(layout.page());
    float[] st = layout.st();
    int at = 6 * triangle;
    double s = (1 - u - v) * st[at] + u * st[at + 2] + v * st[at + 4];
    double t = (1 - u - v) * st[at + 1] + u * st[at + 3] + v * st[at + 5];
    int x = (int) Math.max(0, Math.min(page.width() - 1, s * page.width()));
    int y = (int) Math.max(0, Math.min(page.height() - 1, t * page.height()));
    for (int c = 0; c < 3; c++) {
      out[c] = pages.irradiance().get(layout.page())[3 * (y * page.width() + x) + c];
    }
  }

  @Override
  public boolean complete() {
    return pages.complete();
  }

  @Override
  public int polygons() {
    int sum = 0;
    for (int i = 0; i < scene.bodies().size(); i++) {
      List<Facet> parts = divided.get(i);
      sum += parts == null ? scene.bodies().get(i).triangles() : parts.size();
    }
    return sum;
  }
}
