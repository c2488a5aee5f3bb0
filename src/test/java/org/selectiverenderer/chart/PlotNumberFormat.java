package org.selectiverenderer.chart;

import org.selectiverenderer.base.decimal.DecimalFormatter;

/** Formats the numbers of plots. */
final class PlotNumberFormat {
  private PlotNumberFormat() {}

  /**
   * With three digits that count, or all those before the point: 12,346, 123, 12.3, 1.23, 0.012.
   */
  static String of(double value) {
    double size = Math.abs(value);
    if (size >= 99.95) {
      return DecimalFormatter.grouped(Math.round(value));
    }
    int digits = size == 0 ? 0 : (int) Math.floor(Math.log10(size) + 1e-9);
    return DecimalFormatter.rounded(value, Math.min(9, 2 - digits));
  }
}
