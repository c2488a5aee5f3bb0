package org.selectiverenderer.radiosity.atlas;

/**
 * Conservative scan conversion of a triangle: finds, row by row of a unit grid, the span of cells
 * that the triangle touches, from the leftmost to the rightmost point of the part of the triangle
 * that lies within the row.
 */
final class TriangleScanConverter {
  private final double[] x = new double[3];
  private final double[] y = new double[3];
  private double from;
  private double to;

  void set(double ax, double ay, double bx, double by, double cx, double cy) {
    x[0] = ax;
    y[0] = ay;
    x[1] = bx;
    y[1] = by;
    x[2] = cx;
    y[2] = cy;
  }

  double bottom() {
    return Math.min(y[0], Math.min(y[1], y[2]));
  }

  double top() {
    return Math.max(y[0], Math.max(y[1], y[2]));
  }

  /**
   * Clips the triangle to the row from height {@code low} to {@code high}; returns false if nothing
   * of it lies there.
   */
  boolean row(double low, double high) {
    from = Double.POSITIVE_INFINITY;
    to = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < 3; i++) {
      int j = i == 2 ? 0 : i + 1;
      if (y[i] >= low && y[i] <= high) {
        reach(x[i]);
      }
      cut(i, j, low);
      cut(i, j, high);
    }
    return from <= to;
  }

  /** Returns the leftmost point of the row. */
  double from() {
    return from;
  }

  /** Returns the rightmost point of the row. */
  double to() {
    return to;
  }

  private void cut(int i, int j, double height) {
    if ((y[i] < height) != (y[j] < height)) {
      reach(x[i] + (x[j] - x[i]) * ((height - y[i]) / (y[j] - y[i])));
    }
  }

  private void reach(double at) {
    from = Math.min(from, at);
    to = Math.max(to, at);
  }
}
