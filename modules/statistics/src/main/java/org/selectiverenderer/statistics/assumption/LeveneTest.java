package org.selectiverenderer.statistics.assumption;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * Levene's test of equal variances in the groups, with medians as Brown and Forsythe proposed
 * (1974, Journal of the American Statistical Association 69): a one-way analysis of variance of the
 * absolute deviations from the groups' medians.
 *
 * @param at the within level; empty when there is one only
 * @param f F with df1 and df2 degrees of freedom; NaN where the deviations do not vary
 */
public record LeveneTest(Optional<String> at, double f, double df1, double df2, double p) {
  static LeveneTest of(Optional<String> at, List<double[]> groups) {
    List<double[]> distances = groups.stream().map(LeveneTest::distances).toList();
    OneWayAnova found = OneWayAnova.of(distances);
    return new LeveneTest(
        at,
        found.f(),
        found.df1(),
        found.df2(),
        TailProbabilities.f(found.f(), found.df1(), found.df2()));
  }

  private static double[] distances(double[] values) {
    double median = new Median().evaluate(values);
    double[] distances = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      distances[i] = Math.abs(values[i] - median);
    }
    return distances;
  }

  /** The F of a one-way analysis of variance with its degrees of freedom. */
  private record OneWayAnova(double f, double df1, double df2) {
    /** An error sum of squares below this share of the total is rounding error. */
    private static final double ROUNDING = 1e-13;

    static OneWayAnova of(List<double[]> groups) {
      double[] all = groups.stream().flatMapToDouble(Arrays::stream).toArray();
      double mean = StatUtils.mean(all);
      double between = 0;
      double within = 0;
      for (double[] group : groups) {
        double own = StatUtils.mean(group);
        between += group.length * (own - mean) * (own - mean);
        for (double value : group) {
          within += (value - own) * (value - own);
        }
      }
      double df1 = groups.size() - 1.0;
      double df2 = all.length - (double) groups.size();
      boolean constant = within <= ROUNDING * StatUtils.sumSq(all);
      return new OneWayAnova(constant ? Double.NaN : between / df1 / (within / df2), df1, df2);
    }
  }
}
