package org.selectiverenderer.base.decimal;

import java.math.BigDecimal;
import java.math.RoundingMode;

/**
 * Formats numbers as decimal text, the same on every machine and in every locale: digits 0 to 9, a
 * decimal point, never a negative zero.
 *
 * <p>The rounded value is the decimal that {@link Double#toString(double)} writes, rounded half to
 * even: 0.125 to two decimals is 0.12, 1.015 is 1.02. Numbers must be finite; others throw a
 * NumberFormatException.
 */
public final class DecimalFormatter {
  private static final double[] TENS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

  /** Below this, the product with a power of ten is accurate to a millionth. */
  private static final double SURE = 1e9;

  /** A count of units above the range in which a double represents every integer. */
  private static final double TOO_MANY = 1e15;

  private DecimalFormatter() {}

  /**
   * Returns how many units of the last decimal make 1, a power of ten.
   *
   * @param decimals 0 to 9
   */
  public static double unit(int decimals) {
    return TENS[decimals];
  }

  /**
   * Formats a number with a fixed number of decimals, never with an exponent: {@code 12.500},
   * {@code 0.000}.
   *
   * @param decimals 0 to 9
   */
  public static String fixed(double value, int decimals) {
    StringBuilder text = new StringBuilder(16);
    appendFixed(text, value, decimals);
    return text.toString();
  }

  /** Appends {@link #fixed}. */
  public static void appendFixed(StringBuilder text, double value, int decimals) {
    if (Math.abs(value * TENS[decimals]) < TOO_MANY) {
      append(text, units(value, decimals), decimals);
    } else {
      BigDecimal exact = BigDecimal.valueOf(value);
      text.append(exact.setScale(decimals, RoundingMode.HALF_EVEN).toPlainString());
    }
  }

  /**
   * Formats a number rounded to so many decimals, without trailing zeros: {@code 12.5}, {@code 0}.
   * Numbers of 10<sup>15</sup> units of the last decimal and more are written as {@link
   * #shortest(float)} writes them.
   *
   * @param decimals 0 to 9
   */
  public static String rounded(double value, int decimals) {
    StringBuilder text = new StringBuilder(16);
    appendRounded(text, value, decimals);
    return text.toString();
  }

  /** Appends {@link #rounded}. */
  public static void appendRounded(StringBuilder text, double value, int decimals) {
    if (!(Math.abs(value * TENS[decimals]) < TOO_MANY)) {
      text.append(shortest((float) value));
      return;
    }
    long units = units(value, decimals);
    int places = units == 0 ? 0 : decimals;
    while (places > 0 && units % 10 == 0) {
      units /= 10;
      places--;
    }
    append(text, units, places);
  }

  /** Returns a number in units of the last decimal, rounded. */
  private static long units(double value, int decimals) {
    double units = value * TENS[decimals];
    double nearest = Math.rint(units);
    if (Math.abs(units) < SURE && Math.abs(units - nearest) < 0.499999) {
      return (long) nearest;
    }
    BigDecimal exact = BigDecimal.valueOf(value);
    return exact.setScale(decimals, RoundingMode.HALF_EVEN).unscaledValue().longValueExact();
  }

  private static void append(StringBuilder text, long units, int decimals) {
    if (units < 0) {
      text.append('-');
    }
    long digits = Math.abs(units);
    long unit = (long) TENS[decimals];
    text.append(digits / unit);
    if (decimals > 0) {
      text.append('.');
      long rest = digits % unit;
      for (long digit = unit / 10; digit > 0; digit /= 10) {
        text.append((char) ('0' + rest / digit % 10));
      }
    }
  }

  /**
   * Returns the shortest text that parses to the same float, without trailing zeros: {@code 0.1},
   * {@code 1E-30}.
   */
  public static String shortest(float value) {
    return shortest(Float.toString(value), 8, 9);
  }

  /** Returns the shortest text that parses to the same double. */
  public static String shortest(double value) {
    return shortest(Double.toString(value), 17, 17);
  }

  /**
   * @param scale the number of decimals from which on an exponent is written
   * @param digits the number of digits before the point from which on an exponent is written
   */
  private static String shortest(String text, int scale, int digits) {
    BigDecimal decimal = new BigDecimal(text).stripTrailingZeros();
    boolean plain = decimal.scale() < scale && decimal.precision() - decimal.scale() < digits;
    return plain ? decimal.toPlainString() : decimal.toString();
  }

  /** Formats a whole number with thousands separators, for people: {@code 1,234}. */
  public static String grouped(long value) {
    StringBuilder text = new StringBuilder().append(value);
    for (int at = text.length() - 3; at > (value < 0 ? 1 : 0); at -= 3) {
      text.insert(at, ',');
    }
    return text.toString();
  }
}
