package org.selectiverenderer.radiosity.atlas;

/**
 * Which squares of a unit grid a triangle touches, row by row: of the part of it that lies within a
 * row the squares from its leftmost to its rightmost point, and no others.
 */
final class TriangleRows {
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

  /** Looks at the part from height {@code low} to {@code high}; false if there is none. */
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

  /** The leftmost point of the row. */
  double from() {
    return from;
  }

  /** The rightmost point of the row. */
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
