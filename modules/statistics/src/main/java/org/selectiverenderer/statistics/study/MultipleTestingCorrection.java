package org.selectiverenderer.statistics.study;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.selectiverenderer.statistics.anova.HolmCorrection;

/** Corrections for multiple testing: many effects are tested in one study. */
public enum MultipleTestingCorrection {
  /** No correction: each test has its own error rate. */
  NONE("not corrected") {
    @Override
    double[] of(List<Double> p) {
      return p.stream().mapToDouble(Double::doubleValue).toArray();
    }
  },
  /**
   * Controls the familywise error rate: the probability of any false positive is at most alpha
   * (Holm 1979).
   */
  HOLM("Holm (1979)") {
    @Override
    double[] of(List<Double> p) {
      return HolmCorrection.adjusted(p);
    }
  },
  /**
   * Controls the false discovery rate: on average, at most a share alpha of the significant effects
   * are false positives (Benjamini and Hochberg 1995, Journal of the Royal Statistical Society B
   * 57).
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

  MultipleTestingCorrection(String title) {
    this.title = title;
  }

  /** Returns the description used in reports. */
  public String title() {
    return title;
  }

  /** Returns the adjusted p of finite p values, in the order given. */
  abstract double[] of(List<Double> p);
}
