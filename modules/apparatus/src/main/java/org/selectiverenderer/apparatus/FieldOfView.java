package org.selectiverenderer.apparatus;

/**
 * The field of view of one eye's flat picture, as the tangents of half its horizontal and half its
 * vertical angle.
 *
 * @param x the horizontal tangent, above 0
 * @param y the vertical tangent, above 0
 */
public record FieldOfView(double x, double y) {
  /** The widest angle in degrees, beyond which a flat picture would become too large. */
  public static final double WIDEST = 170;

  public FieldOfView {
    if (!(x > 0) || !(y > 0) || x == Double.POSITIVE_INFINITY || y == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException("the tangents of a field of view must be above 0");
    }
  }

  /**
   * Returns the field of view of a picture with square pixels from the angle between opposite
   * corners, which manufacturers of displays state.
   *
   * @param degrees above 0, at most {@link #WIDEST}
   */
  public static FieldOfView diagonal(double degrees, int width, int height) {
    double corner = tangent(degrees) / Math.hypot(width, height);
    return new FieldOfView(corner * width, corner * height);
  }

  /**
   * Returns the field of view from both angles in degrees, each above 0 and at most {@link
   * #WIDEST}.
   */
  public static FieldOfView angles(double horizontal, double vertical) {
    return new FieldOfView(tangent(horizontal), tangent(vertical));
  }

  private static double tangent(double degrees) {
    if (!(degrees > 0 && degrees <= WIDEST)) {
      throw new IllegalArgumentException(
          "a field of view in degrees must be above 0 and at most " + WIDEST);
    }
    return Math.tan(Math.toRadians(degrees) / 2);
  }

  /** Returns the angle from left to right in degrees. */
  public double horizontal() {
    return 2 * Math.toDegrees(Math.atan(x));
  }

  /** Returns the angle from bottom to top in degrees. */
  public double vertical() {
    return 2 * Math.toDegrees(Math.atan(y));
  }

  /** Returns the angle from corner to corner in degrees. */
  public double diagonal() {
    return 2 * Math.toDegrees(Math.atan(Math.hypot(x, y)));
  }
}
