package org.selectiverenderer.geometry.nurbs;

/**
 * A curve of any number of dimensions. Immutable.
 *
 * @param basis its basis functions
 * @param points homogeneous, one after the other
 * @param dimensions numbers per point
 * @param weights one per point, above 0
 */
public record RationalCurve(Basis basis, double[] points, int dimensions, double[] weights) {

  /**
   * The point at a parameter, and the direction.
   *
   * @return the point's numbers, then those of the derivative
   */
  public double[] at(double u) {
    int order = basis.degree() + 1;
    double[] values = new double[order];
    double[] slopes = new double[order];
    int first = basis.first(u);
    basis.evaluate(u, first, values, slopes);
    double[] out = new double[2 * dimensions];
    double weight = 0;
    double weightSlope = 0;
    for (int i = 0; i < order; i++) {
      for (int d = 0; d < dimensions; d++) {
        double value = points[dimensions * (first + i) + d];
        out[d] += values[i] * value;
        out[dimensions + d] += slopes[i] * value;
      }
      weight += values[i] * weights[first + i];
      weightSlope += slopes[i] * weights[first + i];
    }
    for (int d = 0; d < dimensions; d++) {
      out[d] /= weight;
      out[dimensions + d] = (out[dimensions + d] - weightSlope * out[d]) / weight;
    }
    return out;
  }
}
