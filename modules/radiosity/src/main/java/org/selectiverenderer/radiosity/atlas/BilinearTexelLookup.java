package org.selectiverenderer.radiosity.atlas;

import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Finds the texels and weights by which bilinear filtering within a chart shows a surface point.
 */
public final class BilinearTexelLookup {
  private final Atlas atlas;
  private final RadiosityScene scene;

  public BilinearTexelLookup(RadiosityScene scene, Atlas atlas) {
    this.scene = scene;
    this.atlas = atlas;
  }

  /** Returns the page of a triangle's body; {@link AtlasPage#NONE} if it has none. */
  public int page(int triangle) {
    return atlas.layouts().get(scene.bodyOf()[triangle]).page();
  }

  /**
   * @param triangle of a body that has a page
   * @param u weight of its second corner
   * @param v weight of its third corner
   * @param texels receives the numbers of up to four texels of its page
   * @param weights receives their weights, which sum to 1
   * @return the number of texels
   */
  public int find(int triangle, double u, double v, int[] texels, float[] weights) {
    int body = scene.bodyOf()[triangle];
    Atlas.Layout layout = atlas.layouts().get(body);
    AtlasPage map = atlas.pages().get(layout.page());
    int own = triangle - scene.bodies().get(body).firstTriangle();
    double x = layout.s(own, u, v) * map.width();
    double y = layout.t(own, u, v) * map.height();
    int chart = chart(map, x, y);
    int left = (int) Math.floor(x - 0.5);
    int bottom = (int) Math.floor(y - 0.5);
    double along = x - 0.5 - left;
    double across = y - 0.5 - bottom;
    int count = 0;
    double sum = 0;
    for (int k = 0; k < 4; k++) {
      int column = left + (k & 1);
      int row = bottom + (k >> 1);
      if (column < 0 || row < 0 || column >= map.width() || row >= map.height()) {
        continue;
      }
      int texel = row * map.width() + column;
      double weight = ((k & 1) == 0 ? 1 - along : along) * (k < 2 ? 1 - across : across);
      if (map.chart()[texel] == chart && weight > 0) {
        texels[count] = texel;
        weights[count++] = (float) weight;
        sum += weight;
      }
    }
    for (int k = 0; k < count; k++) {
      weights[k] /= (float) sum;
    }
    return count;
  }

  /**
   * Returns the chart at a point of a page: that of the texel there, or of the closest one beside
   * it if rounding has left the chart.
   */
  private static int chart(AtlasPage map, double x, double y) {
    int column = Math.max(0, Math.min(map.width() - 1, (int) x));
    int row = Math.max(0, Math.min(map.height() - 1, (int) y));
    int chart = map.chart()[row * map.width() + column];
    double best = Double.POSITIVE_INFINITY;
    for (int k = 0; k < 9 && chart == AtlasPage.NONE; k++) {
      int nx = column + k % 3 - 1;
      int ny = row + k / 3 - 1;
      if (nx < 0 || ny < 0 || nx >= map.width() || ny >= map.height()) {
        continue;
      }
      int other = map.chart()[ny * map.width() + nx];
      double dx = nx + 0.5 - x;
      double dy = ny + 0.5 - y;
      double distance = dx * dx + dy * dy;
      if (other != AtlasPage.NONE && distance < best) {
        best = distance;
        chart = other;
      }
    }
    return chart;
  }
}
