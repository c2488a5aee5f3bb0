package org.selectiverenderer.modelling;

/** Polygon offsetting: moves closed lines to their left, corner by corner. */
final class PolygonOffset {
  /** Mitre limit: largest distance that a sharp corner is moved, as a multiple of the offset. */
  private static final double MITRE = 4;

  private PolygonOffset() {}

  /**
   * Returns the line moved inwards if it is counter-clockwise; a hole, which is clockwise, grows.
   */
  static double[] inset(double[] xy, double distance) {
    int n = xy.length;
    double[] out = new double[n];
    for (int i = 0; i < n; i += 2) {
      double[] u = unit(xy, (i + n - 2) % n, i);
      double[] v = unit(xy, i, (i + 2) % n);
      // The bisector of the two edges' left normals, with the length that gives both edges their
      // offset.
      double bx = -u[1] - v[1];
      double by = u[0] + v[0];
      double cosine = (1 + u[0] * v[0] + u[1] * v[1]) / 2;
      double factor = distance / Math.max(2 * cosine, 2 / (MITRE * MITRE));
      out[i] = xy[i] + factor * bx;
      out[i + 1] = xy[i + 1] + factor * by;
    }
    for (int i = 0; i < n; i += 2) {
      int j = (i + 2) % n;
      double before = (xy[j] - xy[i]) * (out[j] - out[i]);
      if (before + (xy[j + 1] - xy[i + 1]) * (out[j + 1] - out[i + 1]) <= 0) {
        throw new IllegalArgumentException(
            "an inset of " + distance + " m is larger than the outline allows");
      }
    }
    return out;
  }

  private static double[] unit(double[] xy, int from, int to) {
    double x = xy[to] - xy[from];
    double y = xy[to + 1] - xy[from + 1];
    double length = Math.sqrt(x * x + y * y);
    return new double[] {x / length, y / length};
  }
}
