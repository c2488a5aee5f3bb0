package org.selectiverenderer.base.decimal;

/** Numbers that stay numbers and lose their further decimals, as figures in JSON do. */
public final class Rounded {
  private Rounded() {}

  /**
   * A number rounded to so many decimals; a tie goes up, as {@link Math#round(double)} has it.
   *
   * @param value finite, less than 9e18 units of the last decimal
   * @param decimals 0 to 9
   */
  public static double to(int decimals, double value) {
    double unit = DecimalText.unit(decimals);
    return Math.round(value * unit) / unit;
  }
}
