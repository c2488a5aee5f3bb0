package org.selectiverenderer.csv;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Numbers with a fixed number of decimals, as every program reads them whatever the locale. */
public final class FixedDecimals {
  private FixedDecimals() {}

  /**
   * The number rounded to so many decimals, all of them written: {@code 12.500}, {@code 0.000};
   * never with an exponent, never a negative zero.
   *
   * @param value finite
   */
  public static String of(double value, int decimals) {
    return BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_EVEN).toPlainString();
  }
}
