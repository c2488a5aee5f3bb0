package org.selectiverenderer.bench.measure;

import java.util.Arrays;

/** Medians. */
final class Medians {
  private Medians() {}

  /** The middle one; of an even number the lower middle. */
  static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[(sorted.length - 1) / 2];
  }
}
