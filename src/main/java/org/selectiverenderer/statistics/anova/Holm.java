package org.selectiverenderer.statistics.anova;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Holm 1979, Scandinavian Journal of Statistics 6: p of several tests, so that one error in all.
 */
public final class Holm {
  private Holm() {}

  /** Adjusted p, in the order given: the largest so far of (m - rank) p, at most 1. */
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
