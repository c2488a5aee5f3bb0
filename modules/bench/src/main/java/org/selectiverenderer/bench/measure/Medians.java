package org.selectiverenderer.bench.measure;

import java.util.Arrays;

/** Computes medians. */
final class Medians {
  private Medians() {}

  /** Returns the median; the lower one of two middle values. */
  static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[(sorted.length - 1) / 2];
  }
}
