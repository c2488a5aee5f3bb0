package org.selectiverenderer.statistics.assumption;

import java.util.List;
import org.apache.commons.math3.stat.StatUtils;
import org.selectiverenderer.statistics.distribution.Tails;

/**
 * Welch's one-way analysis of variance, which does not assume equal variances (Welch 1951,
 * Biometrika 38).
 *
 * @param df2 degrees of freedom of the error by Welch's approximation, not a whole number
 */
public record Welch(double f, double df1, double df2, double p) {
  /** Runs the test; F and p are NaN where a group has one value or no variance. */
  static Welch of(List<double[]> groups) {
    double k = groups.size();
    double weights = 0;
    double centre = 0;
    for (double[] group : groups) {
      double weight = group.length / StatUtils.variance(group);
      weights += weight;
      centre += weight * StatUtils.mean(group);
    }
    centre /= weights;
    double between = 0;
    double lack = 0;
    for (double[] group : groups) {
      double weight = group.length / StatUtils.variance(group);
      between += weight * Math.pow(StatUtils.mean(group) - centre, 2);
      lack += Math.pow(1 - weight / weights, 2) / (group.length - 1);
    }
    double f = between / (k - 1) / (1 + 2 * (k - 2) / (k * k - 1) * lack);
    double df2 = (k * k - 1) / (3 * lack);
    return Double.isFinite(f) && Double.isFinite(df2)
        ? new Welch(f, k - 1, df2, Tails.f(f, k - 1, df2))
        : new Welch(Double.NaN, k - 1, Double.NaN, Double.NaN);
  }
}
