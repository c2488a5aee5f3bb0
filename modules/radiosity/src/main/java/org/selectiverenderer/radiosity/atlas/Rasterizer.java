package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;

/**
 * Rasterizes flattened triangles into a page: finds for each texel the triangle and the surface
 * point closest to its centre.
 */
final class Rasterizer {
  /** Overlap of a triangle and a texel that counts as rounding, texels. */
  private static final double TOUCH = 1e-4;

  private final int width;
  private final int height;
  private final int[] triangle;
  private final float[] u;
  private final float[] v;
  private final int[] chart;

  /** Per texel: the squared distance from its centre to the triangle that it shows. */
  private final float[] away;

  private final TriangleScanConverter rows = new TriangleScanConverter();
  private final double[] place = new double[2];

  Rasterizer(int width, int height) {
    this.width = width;
    this.height = height;
    int texels = width * height;
    triangle = new int[texels];
    chart = new int[texels];
    u = new float[texels];
    v = new float[texels];
    away = new float[texels];
    Arrays.fill(triangle, AtlasPage.NONE);
    Arrays.fill(chart, AtlasPage.NONE);
    Arrays.fill(away, Float.POSITIVE_INFINITY);
  }

  AtlasPage map() {
    return new AtlasPage(width, height, triangle, u, v, chart);
  }

  /**
   * Rasterizes a triangle.
   *
   * @param id number of the triangle in the scene
   * @param box number of the chart's box; also the chart's number
   * @param p x, y of the triangle's corners, texels
   */
  void draw(int id, int box, ChartRectangles boxes, double[] p) {
    rows.set(p[0], p[1], p[2], p[3], p[4], p[5]);
    int bottom = boxes.y[box];
    int top = bottom + boxes.height[box] - 1;
    int low = between(bottom, (int) Math.floor(rows.bottom() + TOUCH), top);
    int high = between(low, (int) Math.ceil(rows.top() - TOUCH) - 1, top);
    int leftmost = boxes.x[box];
    int rightmost = leftmost + boxes.width[box] - 1;
    for (int row = low; row <= high; row++) {
      // A triangle that only touches a row is rasterized where it touches it.
      if (!rows.row(row - TOUCH, row + 1 + TOUCH)) {
        continue;
      }
      int left = between(leftmost, (int) Math.floor(rows.from() + TOUCH), rightmost);
      int right = between(left, (int) Math.ceil(rows.to() - TOUCH) - 1, rightmost);
      for (int column = left; column <= right; column++) {
        int texel = row * width + column;
        if (away[texel] > 0) {
          float distance =
              (float) ClosestPointOnTriangle2d.nearest(p, column + 0.5, row + 0.5, place);
          if (distance < away[texel]) {
            away[texel] = distance;
            triangle[texel] = id;
            chart[texel] = box;
            u[texel] = (float) place[0];
            v[texel] = (float) place[1];
          }
        }
      }
    }
  }

  private static int between(int low, int value, int high) {
    return Math.max(low, Math.min(high, value));
  }
}
