package org.selectiverenderer.hmd;

/**
 * How large one eye's flat picture looks: the tangents of half its horizontal and half its vertical
 * angle.
 *
 * @param x above 0
 * @param y above 0
 */
public record FieldOfView(double x, double y) {
  /** Beyond it a flat picture stretches without bound. */
  public static final double WIDEST = 170;

  public FieldOfView {
    if (!(x > 0) || !(y > 0) || x == Double.POSITIVE_INFINITY || y == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException("a field of view must be larger than 0");
    }
  }

  /**
   * A picture of square pixels by the angle from corner to corner, as makers of displays state it.
   *
   * @param degrees above 0, at most {@link #WIDEST}
   */
  public static FieldOfView diagonal(double degrees, int width, int height) {
    double corner = tangent(degrees) / Math.hypot(width, height);
    return new FieldOfView(corner * width, corner * height);
  }

  /** By both angles in degrees, each above 0 and at most {@link #WIDEST}. */
  public static FieldOfView angles(double horizontal, double vertical) {
    return new FieldOfView(tangent(horizontal), tangent(vertical));
  }

  private static double tangent(double degrees) {
    if (!(degrees > 0 && degrees <= WIDEST)) {
      throw new IllegalArgumentException("an angle of view must be above 0 and at most " + WIDEST);
    }
    return Math.tan(Math.toRadians(degrees) / 2);
  }

  /** Degrees from left to right. */
  public double horizontal() {
    return 2 * Math.toDegrees(Math.atan(x));
  }

  /** Degrees from bottom to top. */
  public double vertical() {
    return 2 * Math.toDegrees(Math.atan(y));
  }

  /** Degrees from corner to corner. */
  public double diagonal() {
    return 2 * Math.toDegrees(Math.atan(Math.hypot(x, y)));
  }
}
