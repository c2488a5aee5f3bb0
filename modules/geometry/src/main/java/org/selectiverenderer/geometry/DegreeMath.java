package org.selectiverenderer.geometry;

/**
 * Trigonometry in degrees with bit-identical results on every machine, which {@link Math#sin} does
 * not guarantee. Generated files must not depend on the machine.
 */
public final class DegreeMath {

  private DegreeMath() {}

  /** Returns the sine; exact at multiples of 90. */
  public static double sin(double degrees) {
    return degrees % 180 == 0 ? 0 : StrictMath.sin(StrictMath.toRadians(degrees));
  }

  /** Returns the cosine; exact at multiples of 90. */
  public static double cos(double degrees) {
    return (degrees - 90) % 180 == 0 ? 0 : StrictMath.cos(StrictMath.toRadians(degrees));
  }

  /** Returns the angle of the direction (x, y), -180 to 180. */
  public static double atan2(double y, double x) {
    return StrictMath.toDegrees(StrictMath.atan2(y, x));
  }

  /** Returns {@code base} to the power {@code exponent}, bit-identical on every machine. */
  public static double power(double base, double exponent) {
    return StrictMath.pow(base, exponent);
  }
}
