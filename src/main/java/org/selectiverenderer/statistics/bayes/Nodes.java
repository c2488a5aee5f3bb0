package org.selectiverenderer.statistics.bayes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The points of the integral over the g of some terms of a component, with what the data say there.
 * g is in units of the variance of the stratum, so that the table holds for any.
 *
 * @param terms how many g a point has
 * @param logWeights of the points, with what the prior has of them for any width: minus half of the
 *     sum of log g
 * @param inverses sums of 1 / g, of each point
 * @param determinants logarithms, of each point, times the number of contrasts
 * @param sums of squares at each point
 */
record Nodes(
    int terms, double[] logWeights, double[] inverses, double[] determinants, double[] sums) {
  private static final double NEGLIGIBLE = 36;

  /** Of no term: one point. */
  static Nodes none(Component component) {
    double[] zero = {0};
    return new Nodes(0, zero, zero, zero, new double[] {component.sum()});
  }

  static Nodes of(
      Component component, List<TermColumns> terms, double[][] logG, double[] logWeights) {
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
    return new Nodes(terms.size(), weights, inverses, determinants, sums);
  }

  /** All combinations of points in equal steps. */
  static Nodes grid(Component component, List<TermColumns> terms, Scale scale, double leastPrior) {
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
   * Logarithm of the integral, without what no g changes.
   *
   * @param variance of the error
   * @param factor of it in this stratum
   * @param r scale of the prior
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
    return top + Math.log(sum) + terms * (InverseGamma.logConstant(r) - Math.log(factor) / 2);
  }

  /**
   * Where log g of a term may lie.
   *
   * @param step that resolves it
   */
  record Range(double low, double high, double step) {
    private static final double LARGEST_STEP = 0.4;

    /** Of the prior's density below the range: e to minus this. */
    private static final double NEGLIGIBLE = 30;

    /** Beyond it, matrices lose their digits. */
    private static final double MOST = 27;

    static Range of(Component component, TermColumns term, Scale scale, double leastPrior) {
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
