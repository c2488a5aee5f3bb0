package org.selectiverenderer.radiosity.light;

/**
 * Computes the irradiance from a flat polygon of one luminance in closed form: half of the
 * luminance times the sum over its edges of the angle that each subtends, projected on the normal
 * (Lambert 1760; Baum, Rushmeier and Winget 1989, equation 11). The polygon is clipped at the
 * receiver's horizon. One per thread and call.
 */
final class PolygonIrradiance {
  private final double[] above = new double[3 * 8];
  private int count;

  /**
   * Returns the irradiance per luminance.
   *
   * @param corners x, y, z of three or four points, in either order
   * @param point the receiver's position
   * @param normal the receiver's unit normal
   */
  double perLuminance(double[] corners, int points, double[] point, double[] normal) {
    clip(corners, points, point, normal);
    double sum = 0;
    for (int i = 0; i < count; i++) {
      int a = 3 * i;
      int b = 3 * ((i + 1) % count);
      double x = above[a + 1] * above[b + 2] - above[a + 2] * above[b + 1];
      double y = above[a + 2] * above[b] - above[a] * above[b + 2];
      double z = above[a] * above[b + 1] - above[a + 1] * above[b];
      double sine = Math.sqrt(x * x + y * y + z * z);
      if (sine > 0) {
        double cosine =
            above[a] * above[b] + above[a + 1] * above[b + 1] + above[a + 2] * above[b + 2];
        double angle = StrictMath.atan2(sine, cosine);
        sum += angle / sine * (x * normal[0] + y * normal[1] + z * normal[2]);
      }
    }
    return Math.abs(sum) / 2;
  }

  /** Keeps the part of the polygon above the horizon, in coordinates relative to the point. */
  private void clip(double[] corners, int points, double[] point, double[] normal) {
    count = 0;
    for (int i = 0; i < points; i++) {
      int a = 3 * i;
      int b = 3 * ((i + 1) % points);
      double here = height(corners, a, point, normal);
      double next = height(corners, b, point, normal);
      if (here >= 0) {
        put(corners, a, b, 0, point);
      }
      if (here < 0 != next < 0) {
        put(corners, a, b, here / (here - next), point);
      }
    }
  }

  private static double height(double[] corners, int at, double[] point, double[] normal) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      sum += (corners[at + axis] - point[axis]) * normal[axis];
    }
    return sum;
  }

  private void put(double[] corners, int a, int b, double share, double[] point) {
    for (int axis = 0; axis < 3; axis++) {
      double from = corners[a + axis];
      above[3 * count + axis] = from + share * (corners[b + axis] - from) - point[axis];
    }
    count++;
  }
}
