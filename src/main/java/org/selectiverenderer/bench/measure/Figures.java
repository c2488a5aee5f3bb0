package org.selectiverenderer.bench.measure;

import java.util.Arrays;

/** Rounding and medians. */
final class Figures {
  private Figures() {}

  static double tenth(double value) {
    return Math.round(value * 10) / 10.0;
  }

  static double hundredth(double value) {
    return Math.round(value * 100) / 100.0;
  }

  /** The middle one; of an even number the lower middle. */
  static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[(sorted.length - 1) / 2];
  }
}
