package org.selectiverenderer.statistics.anova;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Holm's correction of p values for multiple testing, which controls the familywise error rate
 * (Holm 1979, Scandinavian Journal of Statistics 6).
 */
public final class HolmCorrection {
  private HolmCorrection() {}

  /**
   * Returns the adjusted p values in the order given: in ascending order of p, the running maximum
   * of (m - rank) p with ranks from 0, at most 1.
   */
  public static double[] adjusted(List<Double> p) {
    int[] order =
        IntStream.range(0, p.size())
            .boxed()
            .sorted(Comparator.comparing(p::get))
            .mapToInt(Integer::intValue)
            .toArray();
    double[] adjusted = new double[p.size()];
    double least = 0;
    for (int rank = 0; rank < order.length; rank++) {
      least = Math.max(least, Math.min(1, (order.length - rank) * p.get(order[rank])));
      adjusted[order[rank]] = Double.isNaN(p.get(order[rank])) ? Double.NaN : least;
    }
    return adjusted;
  }
}
