package org.selectiverenderer.tracker.report;

/** Numbers as other programs read them, whatever the locale. */
final class Decimals {
  private Decimals() {}

  /** The number with at most that many decimals: {@code 12.5}, {@code 0.0}. */
  static String of(double value, int decimals) {
    double scale = Math.pow(10, decimals);
    double rounded = Math.rint(value * scale) / scale;
    return Double.toString(rounded == 0 ? 0.0 : rounded); // Never -0.0.
  }
}
