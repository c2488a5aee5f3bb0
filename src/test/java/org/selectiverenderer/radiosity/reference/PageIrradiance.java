package org.selectiverenderer.radiosity.reference;

import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.texel.LightPages;

/** Light at texels, between four of them as a graphics card takes it. */
final class PageIrradiance implements Irradiance {
  private final LightScene scene;
  private final LightPages pages;

  PageIrradiance(LightScene scene, LightPages pages) {
    this.scene = scene;
    this.pages = pages;
  }

  @Override
  public void at(int triangle, double u, double v, double[] out) {
    int number = scene.bodyOf()[triangle];
    Body body = scene.bodies().get(number);
    Atlas.Layout layout = pages.atlas().layouts().get(number);
    TexelMap page = pages.atlas().pages().get(layout.page());
    float[] light = pages.irradiance().get(layout.page());
    int corner = 6 * (triangle - body.firstTriangle());
    double x = page.width() * between(layout.st(), corner, u, v) - 0.5;
    double y = page.height() * between(layout.st(), corner + 1, u, v) - 0.5;
    int left = (int) Math.floor(x);
    int low = (int) Math.floor(y);
    out[0] = 0;
    out[1] = 0;
    out[2] = 0;
    for (int k = 0; k < 4; k++) {
      int column = left + k % 2;
      int row = low + k / 2;
      double weight = (1 - Math.abs(x - column)) * (1 - Math.abs(y - row));
      int texel = clamp(row, page.height()) * page.width() + clamp(column, page.width());
      for (int c = 0; c < 3; c++) {
        out[c] += weight * light[3 * texel + c];
      }
    }
  }

  private static double between(float[] st, int at, double u, double v) {
    return (1 - u - v) * st[at] + u * st[at + 2] + v * st[at + 4];
  }

  private static int clamp(int value, int size) {
    return Math.max(0, Math.min(size - 1, value));
  }
}
