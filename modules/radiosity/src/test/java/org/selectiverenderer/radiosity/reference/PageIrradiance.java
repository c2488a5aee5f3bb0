package org.selectiverenderer.radiosity.reference;

import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.bake.LightmappedScene;

/** Light at texels, between four of them as it is drawn. */
final class PageIrradiance implements Irradiance {
  private final LightmappedScene lit;

  PageIrradiance(LightmappedScene lit) {
    this.lit = lit;
  }

  @Override
  public void at(int triangle, double u, double v, double[] out) {
    int body = lit.scene().bodyOf()[triangle];
    Atlas.Layout layout = lit.atlas().layouts().get(body);
    int corner = 6 * (triangle - lit.scene().bodies().get(body).firstTriangle());
    lit.pages()
        .at(
            layout.page(),
            between(layout.st(), corner, u, v),
            between(layout.st(), corner + 1, u, v),
            out);
  }

  private static double between(float[] st, int at, double u, double v) {
    return (1 - u - v) * st[at] + u * st[at + 2] + v * st[at + 4];
  }
}
