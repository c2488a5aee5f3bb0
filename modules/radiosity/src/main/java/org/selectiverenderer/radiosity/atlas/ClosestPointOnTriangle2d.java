package org.selectiverenderer.radiosity.atlas;

/** Closest point on a triangle in the plane of a page. */
final class ClosestPointOnTriangle2d {
  private ClosestPointOnTriangle2d() {}

  /**
   * Finds the point of the triangle that is closest to (x, y).
   *
   * @param p x, y of the three corners
   * @param out receives the barycentric weights of the second and third corner
   * @return the square of the distance, 0 inside
   */
  static double nearest(double[] p, double x, double y, double[] out) {
    double bx = p[2] - p[0];
    double by = p[3] - p[1];
    double cx = p[4] - p[0];
    double cy = p[5] - p[1];
    double area = bx * cy - by * cx;
    if (area != 0) {
      double u = ((x - p[0]) * cy - (y - p[1]) * cx) / area;
      double v = ((y - p[1]) * bx - (x - p[0]) * by) / area;
      if (u >= 0 && v >= 0 && u + v <= 1) {
        out[0] = u;
        out[1] = v;
        return 0;
      }
    }
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 3; i++) {
      int a = 2 * i;
      int b = 2 * ((i + 1) % 3);
      double dx = p[b] - p[a];
      double dy = p[b + 1] - p[a + 1];
      double length = dx * dx + dy * dy;
      double t = length > 0 ? ((x - p[a]) * dx + (y - p[a + 1]) * dy) / length : 0;
      t = Math.max(0, Math.min(1, t));
      double ex = p[a] + t * dx - x;
      double ey = p[a + 1] + t * dy - y;
      double distance = ex * ex + ey * ey;
      if (distance < best) {
        best = distance;
        out[0] = i == 0 ? t : i == 1 ? 1 - t : 0;
        out[1] = i == 0 ? 0 : i == 1 ? t : 1 - t;
      }
    }
    return best;
  }
}
