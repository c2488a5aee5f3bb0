package org.selectiverenderer.polygon.model;

import java.math.BigDecimal;

/** Numbers as X3D text, the same on every machine and in every locale. */
public final class NumberText {
  private static final double[] TENS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

  private NumberText() {}

  /** Appends a number rounded to so many decimals, at most 9, without zeros that say nothing. */
  public static void append(StringBuilder text, double value, int decimals) {
    double scaled = Math.rint(value * TENS[decimals]);
    if (!(Math.abs(scaled) < 1e15)) {
      text.append(shortest((float) value));
      return;
    }
    long digits = Math.abs((long) scaled);
    if (digits == 0) {
      text.append('0');
      return;
    }
    if (scaled < 0) {
      text.append('-');
    }
    int places = decimals;
    while (places > 0 && digits % 10 == 0) {
      digits /= 10;
      places--;
    }
    long unit = (long) TENS[places];
    text.append(digits / unit);
    if (places > 0) {
      text.append('.');
      String fraction = Long.toString(digits % unit);
      text.append("0".repeat(places - fraction.length())).append(fraction);
    }
  }

  /** The shortest text that reads as that very float. */
  public static String shortest(float value) {
    BigDecimal decimal = new BigDecimal(Float.toString(value)).stripTrailingZeros();
    boolean plain = decimal.scale() < 8 && decimal.precision() - decimal.scale() < 9;
    return plain ? decimal.toPlainString() : decimal.toString();
  }

  /** The shortest text that reads as that very double. */
  public static String shortest(double value) {
    BigDecimal decimal = new BigDecimal(Double.toString(value)).stripTrailingZeros();
    boolean plain = decimal.scale() < 17 && decimal.precision() - decimal.scale() < 17;
    return plain ? decimal.toPlainString() : decimal.toString();
  }
}
