package org.selectiverenderer.geometry.nurbs;

/**
 * A NURBS surface. Immutable.
 *
 * @param u the B-spline basis along the rows of control points
 * @param v the B-spline basis along the columns of control points
 * @param points control points in homogeneous form, each already multiplied by its weight, in rows
 *     of {@code u.count()}
 * @param dimensions numbers per control point
 * @param weights one weight per control point, above 0
 */
public record NurbsSurface(
    BSplineBasis u, BSplineBasis v, double[] points, int dimensions, double[] weights) {

  /**
   * Evaluates the point and the partial derivatives at two parameters.
   *
   * @return the coordinates of the point, then of the derivative by u, then of that by v
   */
  public double[] at(double atU, double atV) {
    int orderU = u.degree() + 1;
    int orderV = v.degree() + 1;
    double[] valuesU = new double[orderU];
    double[] slopesU = new double[orderU];
    double[] valuesV = new double[orderV];
    double[] slopesV = new double[orderV];
    int firstU = u.first(atU);
    int firstV = v.first(atV);
    u.evaluate(atU, firstU, valuesU, slopesU);
    v.evaluate(atV, firstV, valuesV, slopesV);
    int n = dimensions;
    double[] out = new double[3 * n];
    double weight = 0;
    double weightU = 0;
    double weightV = 0;
    for (int j = 0; j < orderV; j++) {
      for (int i = 0; i < orderU; i++) {
        int point = (firstV + j) * u.count() + firstU + i;
        double value = valuesU[i] * valuesV[j];
        double byU = slopesU[i] * valuesV[j];
        double byV = valuesU[i] * slopesV[j];
        for (int d = 0; d < n; d++) {
          double coordinate = points[n * point + d];
          out[d] += value * coordinate;
          out[n + d] += byU * coordinate;
          out[2 * n + d] += byV * coordinate;
        }
        weight += value * weights[point];
        weightU += byU * weights[point];
        weightV += byV * weights[point];
      }
    }
    for (int d = 0; d < n; d++) {
      out[d] /= weight;
      out[n + d] = (out[n + d] - weightU * out[d]) / weight;
      out[2 * n + d] = (out[2 * n + d] - weightV * out[d]) / weight;
    }
    return out;
  }
}
