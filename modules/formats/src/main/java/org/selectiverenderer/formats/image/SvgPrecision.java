package org.selectiverenderer.formats.image;

import java.util.Locale;

/** The number of decimals in a drawing. */
public enum SvgPrecision {
  /** Exactly one decimal: {@code 12.0}. */
  TENTHS,

  /** Up to two decimals: {@code 12.34}, {@code 12.3}, {@code 12}. */
  HUNDREDTHS;

  String of(double number) {
    return this == TENTHS
        ? String.format(Locale.ROOT, "%.1f", number)
        : String.format(Locale.ROOT, "%.2f", number).replaceFirst("\\.?0+$", "");
  }
}
