package org.selectiverenderer.geometry;

/**
 * Trigonometry in degrees with the same bits on every machine, which {@link Math#sin} does not
 * promise: a generated file must not depend on where it was made.
 */
public final class Degrees {

  private Degrees() {}

  /** The sine; exact at multiples of 90. */
  public static double sin(double degrees) {
    return degrees % 180 == 0 ? 0 : StrictMath.sin(StrictMath.toRadians(degrees));
  }

  /** The cosine; exact at multiples of 90. */
  public static double cos(double degrees) {
    return (degrees - 90) % 180 == 0 ? 0 : StrictMath.cos(StrictMath.toRadians(degrees));
  }

  /** The angle of the direction (x, y), -180 to 180. */
  public static double atan2(double y, double x) {
    return StrictMath.toDegrees(StrictMath.atan2(y, x));
  }

  /** {@code base} to the power {@code exponent}, the same bits everywhere as well. */
  public static double power(double base, double exponent) {
    return StrictMath.pow(base, exponent);
  }
}
