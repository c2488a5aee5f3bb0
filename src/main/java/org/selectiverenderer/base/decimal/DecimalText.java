package org.selectiverenderer.base.decimal;

import java.math.BigDecimal;
import java.math.RoundingMode;

/**
 * Numbers as decimal text, the same on every machine and in every locale: digits 0 to 9, a point,
 * never a negative zero.
 *
 * <p>What is rounded is the number as {@link Double#toString(double)} writes it, to the nearest
 * decimal; a tie goes to the even digit: 0.125 to two decimals is 0.12, 1.015 is 1.02. Numbers must
 * be finite, otherwise a NumberFormatException is thrown.
 */
public final class DecimalText {
  private static final double[] TENS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

  /** Below this, a product with a power of ten is right to a millionth. */
  private static final double SURE = 1e9;

  /** More units than a double holds without gaps. */
  private static final double TOO_MANY = 1e15;

  private DecimalText() {}

  /**
   * How many units of the last decimal make 1.
   *
   * @param decimals 0 to 9
   */
  public static double unit(int decimals) {
    return TENS[decimals];
  }

  /**
   * With that many decimals, all of them written: {@code 12.500}, {@code 0.000}; never with an
   * exponent.
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
   * Rounded to so many decimals, without zeros that say nothing: {@code 12.5}, {@code 0}. Numbers
   * of 10<sup>15</sup> units of the last decimal and more are written as {@link #shortest(float)}.
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

  /** How many units of the last decimal a number is. */
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
   * The shortest text that reads as that very float, without zeros that say nothing: {@code 0.1},
   * {@code 1E-30}.
   */
  public static String shortest(float value) {
    return shortest(Float.toString(value), 8, 9);
  }

  /** The shortest text that reads as that very double. */
  public static String shortest(double value) {
    return shortest(Double.toString(value), 17, 17);
  }

  /**
   * @param scale the least number of decimals that may be written with an exponent
   * @param digits the least number of digits before the point that is
   */
  private static String shortest(String text, int scale, int digits) {
    BigDecimal decimal = new BigDecimal(text).stripTrailingZeros();
    boolean plain = decimal.scale() < scale && decimal.precision() - decimal.scale() < digits;
    return plain ? decimal.toPlainString() : decimal.toString();
  }

  /** A whole number in groups of three digits, for people: {@code 1,234}. */
  public static String grouped(long value) {
    StringBuilder text = new StringBuilder().append(value);
    for (int at = text.length() - 3; at > (value < 0 ? 1 : 0); at -= 3) {
      text.insert(at, ',');
    }
    return text.toString();
  }
}
