package org.selectiverenderer.enricher.images;

import java.util.Locale;

/** Formats numbers of bytes for people. */
public final class ByteFormat {
  private static final String[] UNITS = {"B", "KB", "MB", "GB"};

  private ByteFormat() {}

  /** Returns a number of bytes with three digits: {@code 340 KB}. */
  public static String of(long bytes) {
    double value = bytes;
    int unit = 0;
    while (value >= 1000 && unit < UNITS.length - 1) {
      value /= 1000;
      unit++;
    }
    String digits = unit == 0 || value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : "%.2f";
    Locale locale = Locale.getDefault(Locale.Category.DISPLAY);
    return String.format(locale, digits, value) + " " + UNITS[unit];
  }
}
