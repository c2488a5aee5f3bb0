package org.selectiverenderer.statistics.study;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.selectiverenderer.statistics.anova.Holm;

/** What is done about testing many effects in one study. */
public enum FamilyCorrection {
  /** Nothing: each test has its own error rate. */
  NONE("not corrected") {
    @Override
    double[] of(List<Double> p) {
      return p.stream().mapToDouble(Double::doubleValue).toArray();
    }
  },
  /** One error in all tests has the probability alpha at most (Holm 1979). */
  HOLM("Holm (1979)") {
    @Override
    double[] of(List<Double> p) {
      return Holm.adjusted(p);
    }
  },
  /**
   * Of the effects that are found, a share of alpha does not exist, on average (Benjamini and
   * Hochberg 1995, Journal of the Royal Statistical Society B 57).
   */
  FDR("false discovery rate (Benjamini and Hochberg 1995)") {
    @Override
    double[] of(List<Double> p) {
      int[] falling =
          IntStream.range(0, p.size())
              .boxed()
              .sorted(Comparator.comparing((Integer i) -> p.get(i)).reversed())
              .mapToInt(Integer::intValue)
              .toArray();
      double[] adjusted = new double[p.size()];
      double most = 1;
      for (int i = 0; i < falling.length; i++) {
        int rank = falling.length - i;
        most = Math.min(most, p.get(falling[i]) * falling.length / rank);
        adjusted[falling[i]] = most;
      }
      return adjusted;
    }
  };

  private final String title;

  FamilyCorrection(String title) {
    this.title = title;
  }

  /** For reports. */
  public String title() {
    return title;
  }

  /** Adjusted p of finite p, in the order given. */
  abstract double[] of(List<Double> p);
}
