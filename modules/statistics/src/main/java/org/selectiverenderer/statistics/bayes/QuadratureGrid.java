package org.selectiverenderer.statistics.bayes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A quadrature grid: the points and weights of the integral over the g of some terms of a {@link
 * Component}, with the likelihood terms of the data at each point. Each g is in units of the
 * variance of the stratum, so that one grid serves any variance.
 *
 * @param terms number of g, the dimension of a point
 * @param logWeights logarithms of the quadrature weights, including the factor of the prior that
 *     does not depend on its scale: minus half of the sum of log g
 * @param inverses sum of 1 / g at each point
 * @param determinants log-determinant at each point, times the number of contrasts
 * @param sums generalised sum of squares of the data at each point
 */
record QuadratureGrid(
    int terms, double[] logWeights, double[] inverses, double[] determinants, double[] sums) {
  private static final double NEGLIGIBLE = 36;

  /** Returns the grid of a model without terms in the component: one point. */
  static QuadratureGrid none(NonorthogonalTermBlock component) {
    double[] zero = {0};
    return new QuadratureGrid(0, zero, zero, zero, new double[] {component.sum()});
  }

  static QuadratureGrid of(
      NonorthogonalTermBlock component,
      List<TermDesignMatrix> terms,
      double[][] logG,
      double[] logWeights) {
    double[] weights = logWeights.clone();
    double[] inverses = new double[logG.length];
    double[] determinants = new double[logG.length];
    double[] sums = new double[logG.length];
    for (int i = 0; i < logG.length; i++) {
      double[] found = component.at(terms, logG[i]);
      determinants[i] = found[0] * component.width();
      sums[i] = found[1];
      for (double g : logG[i]) {
        weights[i] -= g / 2;
        inverses[i] += Math.exp(-g);
      }
    }
    return new QuadratureGrid(terms.size(), weights, inverses, determinants, sums);
  }

  /** Returns the grid of all combinations of equally spaced points of log g. */
  static QuadratureGrid grid(
      NonorthogonalTermBlock component,
      List<TermDesignMatrix> terms,
      VarianceEstimates scale,
      double leastPrior) {
    List<double[]> points = List.of(new double[] {});
    double volume = 0;
    for (int t = 0; t < terms.size(); t++) {
      Range range = Range.of(component, terms.get(t), scale, leastPrior);
      List<double[]> longer = new ArrayList<>();
      for (double[] point : points) {
        for (double at = range.low(); at <= range.high(); at += range.step()) {
          double[] next = Arrays.copyOf(point, t + 1);
          next[t] = at;
          longer.add(next);
        }
      }
      points = longer;
      volume += Math.log(range.step());
    }
    double[] weights = new double[points.size()];
    Arrays.fill(weights, volume);
    return of(component, terms, points.toArray(double[][]::new), weights);
  }

  /**
   * Returns the logarithm of the integral over g, without factors that depend on no g.
   *
   * @param variance error variance
   * @param factor variance of this stratum in units of the error variance
   * @param r scale of the Cauchy prior
   */
  double log(double variance, double factor, double r) {
    double prior = r * r / (2 * factor);
    double data = 1 / (2 * variance * factor);
    double[] logs = new double[sums.length];
    double top = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < logs.length; i++) {
      logs[i] = logWeights[i] - determinants[i] / 2 - prior * inverses[i] - data * sums[i];
      top = Math.max(top, logs[i]);
    }
    double sum = 0;
    for (double log : logs) {
      if (log > top - NEGLIGIBLE) {
        sum += Math.exp(log - top);
      }
    }
    return top + Math.log(sum) + terms * (InverseGammaPrior.logConstant(r) - Math.log(factor) / 2);
  }

  /**
   * The interval of log g of a term outside which the integrand is negligible.
   *
   * @param step spacing of the points that resolves the integrand
   */
  record Range(double low, double high, double step) {
    private static final double LARGEST_STEP = 0.4;

    /** Below the interval, the prior's density is at most e to minus this number. */
    private static final double NEGLIGIBLE = 30;

    /** Beyond this log g, the matrices lose all significant digits. */
    private static final double MOST = 27;

    static Range of(
        NonorthogonalTermBlock component,
        TermDesignMatrix term,
        VarianceEstimates scale,
        double leastPrior) {
      double falls = 1.0 + (double) component.width() * term.matrix().getColumnDimension();
      double low = Math.log(leastPrior * leastPrior / (2 * NEGLIGIBLE) / scale.average());
      double signal = component.sum() / (scale.variance() * term.size());
      double high = Math.log(Math.max(4, Math.max(1 / term.size(), signal)));
      return new Range(
          low,
          Math.min(Math.max(MOST, high + 5), high + 2 * NEGLIGIBLE / falls),
          Math.min(LARGEST_STEP, 0.8 * Math.sqrt(2 / falls)));
    }
  }
}
