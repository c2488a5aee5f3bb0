package org.selectiverenderer.geometry.nurbs;

/**
 * A NURBS curve in any number of dimensions. Immutable.
 *
 * @param basis the B-spline basis
 * @param points control points in homogeneous form, each already multiplied by its weight
 * @param dimensions numbers per control point
 * @param weights one weight per control point, above 0
 */
public record NurbsCurve(BSplineBasis basis, double[] points, int dimensions, double[] weights) {

  /**
   * Evaluates the point and the first derivative at a parameter.
   *
   * @return the coordinates of the point, then those of the derivative
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
