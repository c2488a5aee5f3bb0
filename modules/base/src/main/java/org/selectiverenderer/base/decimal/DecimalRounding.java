package org.selectiverenderer.base.decimal;

/** Rounds numbers to a number of decimals, for figures in JSON. */
public final class DecimalRounding {
  private DecimalRounding() {}

  /**
   * Returns a number rounded to so many decimals, half up as {@link Math#round(double)} does.
   *
   * @param value finite, less than 9e18 units of the last decimal
   * @param decimals 0 to 9
   */
  public static double to(int decimals, double value) {
    double unit = DecimalFormatter.unit(decimals);
    return Math.round(value * unit) / unit;
  }
}
