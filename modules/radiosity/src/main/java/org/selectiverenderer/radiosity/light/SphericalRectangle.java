package org.selectiverenderer.radiosity.light;

/**
 * Samples points of a rectangle uniformly over the solid angle that it subtends (Urena, Fajardo and
 * King 2013, "An Area-Preserving Parametrization for Spherical Rectangles"), so that all points
 * have the same weight however near the rectangle is. One per thread.
 */
final class SphericalRectangle {
  // The rectangle in a frame with the receiver as origin and sides along x and y; z is below 0.
  private double x0;
  private double x1;
  private double y0;
  private double y1;
  private double z;
  private double first;
  private double last;
  private double turn;
  private double solidAngle;

  /** The sampled point: metres along the width and the height from the corner of lowest x and y. */
  double across;

  double along;

  /**
   * Sets the rectangle.
   *
   * @param left signed distance along its width from the receiver's projection on its plane to its
   *     left edge, metres, and so {@code right}
   * @param bottom the same along its height, and so {@code top}
   * @param height of the receiver above its plane, metres; above 0
   * @return the solid angle, steradian
   */
  double look(double left, double right, double bottom, double top, double height) {
    x0 = left;
    x1 = right;
    y0 = bottom;
    y1 = top;
    z = -height;
    double lowY = Math.sqrt(z * z + y0 * y0);
    double highY = Math.sqrt(z * z + y1 * y1);
    double lowX = Math.sqrt(z * z + x0 * x0);
    double highX = Math.sqrt(z * z + x1 * x1);
    // The interior angles of the spherical rectangle.
    double a = angle(y0 * x1 / (lowY * highX));
    double b = angle(-x1 * y1 / (highX * highY));
    double c = angle(y1 * x0 / (highY * lowX));
    double d = angle(-x0 * y0 / (lowX * lowY));
    first = -y0 / lowY;
    last = y1 / highY;
    turn = 2 * Math.PI - c - d;
    solidAngle = Math.max(0, a + b - turn);
    return solidAngle;
  }

  private static double angle(double cosine) {
    return StrictMath.acos(Math.max(-1, Math.min(1, cosine)));
  }

  /**
   * Samples a point of the rectangle.
   *
   * @param s from 0 to 1; with {@code t} it chooses the direction in the solid angle
   */
  void place(double s, double t) {
    double at = s * solidAngle + turn;
    double f = (StrictMath.cos(at) * first - last) / StrictMath.sin(at);
    double cosine = Math.min(1, 1 / Math.sqrt(f * f + first * first));
    cosine = f > 0 ? cosine : -cosine;
    double x = -cosine * z / Math.sqrt(1 - cosine * cosine);
    x = x > x0 ? Math.min(x1, x) : x0;
    double square = x * x + z * z;
    double low = y0 / Math.sqrt(square + y0 * y0);
    double high = y1 / Math.sqrt(square + y1 * y1);
    double sine = low + t * (high - low);
    double y = sine * Math.sqrt(square) / Math.sqrt(Math.max(1e-300, 1 - sine * sine));
    across = x - x0;
    along = (y > y0 ? Math.min(y1, y) : y0) - y0;
  }
}
