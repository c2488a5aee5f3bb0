package org.selectiverenderer.modelling;

/** Computes Catmull-Rom splines in any dimension. */
final class CatmullRomSpline {

  private CatmullRomSpline() {}

  /**
   * Returns a Catmull-Rom spline (Catmull and Rom, 1974) through all points.
   *
   * @param points {@code dimension} coordinates each
   * @param closed whether the last point joins the first
   * @param steps number of segments between two neighbouring points
   * @return the points on the spline; a closed one does not repeat its first
   */
  static double[] through(double[] points, int dimension, boolean closed, int steps) {
    int n = points.length / dimension;
    int spans = closed ? n : n - 1;
    double[] out = new double[dimension * (spans * steps + (closed ? 0 : 1))];
    for (int span = 0; span < spans; span++) {
      for (int step = 0; step < steps; step++) {
        for (int k = 0; k < dimension; k++) {
          double t = (double) step / steps;
          double a = at(points, dimension, closed, span - 1, k);
          double b = at(points, dimension, closed, span, k);
          double c = at(points, dimension, closed, span + 1, k);
          double d = at(points, dimension, closed, span + 2, k);
          out[dimension * (span * steps + step) + k] =
              b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
        }
      }
    }
    if (!closed) {
      System.arraycopy(points, dimension * (n - 1), out, dimension * spans * steps, dimension);
    }
    return out;
  }

  /**
   * Returns a coordinate of a point; beyond the ends of an open spline it is extrapolated linearly.
   */
  private static double at(double[] points, int dimension, boolean closed, int i, int k) {
    int n = points.length / dimension;
    if (closed) {
      return points[dimension * Math.floorMod(i, n) + k];
    }
    if (i < 0) {
      return 2 * points[k] - points[dimension + k];
    }
    if (i >= n) {
      return 2 * points[dimension * (n - 1) + k] - points[dimension * (n - 2) + k];
    }
    return points[dimension * i + k];
  }
}
