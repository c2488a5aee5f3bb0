package org.selectiverenderer.statistics.assumption;

import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.selectiverenderer.statistics.distribution.Tails;

/**
 * Levene's test of equal variances in the groups, with medians as Brown and Forsythe proposed
 * (1974, Journal of the American Statistical Association 69): a one-way analysis of variance of the
 * absolute deviations from the groups' medians.
 *
 * @param at the within level; empty when there is one only
 * @param f F with df1 and df2 degrees of freedom; NaN where the deviations do not vary
 */
public record Levene(Optional<String> at, double f, double df1, double df2, double p) {
  static Levene of(Optional<String> at, List<double[]> groups) {
    List<double[]> distances = groups.stream().map(Levene::distances).toList();
    OneWay found = OneWay.of(distances);
    return new Levene(
        at, found.f(), found.df1(), found.df2(), Tails.f(found.f(), found.df1(), found.df2()));
  }

  private static double[] distances(double[] values) {
    double median = new Median().evaluate(values);
    double[] distances = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      distances[i] = Math.abs(values[i] - median);
    }
    return distances;
  }
}
