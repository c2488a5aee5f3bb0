package org.selectiverenderer.statistics.assumption;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.stat.StatUtils;

/** The F of a one-way analysis of variance with its degrees of freedom. */
record OneWay(double f, double df1, double df2) {
  /** An error sum of squares below this share of the total is rounding error. */
  private static final double ROUNDING = 1e-13;

  static OneWay of(List<double[]> groups) {
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
    return new OneWay(constant ? Double.NaN : between / df1 / (within / df2), df1, df2);
  }
}
