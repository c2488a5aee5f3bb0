package org.selectiverenderer.tracker;

/**
 * The thesis's own conversion of the tracker's angles (Fig 50, {@code setViewpoinFromTracker}),
 * kept to compare with.
 *
 * <p>It composes heading about Y, attitude about Z and bank about X, in the order YZX. That is
 * right for an object that looks along +X. The viewer of X3D looks along -Z, where the formula
 * would take a nod for a tilt of the head and the other way round; so {@link Orientation} is what
 * is used. The two agree where only the heading differs from 0.
 */
final class ThesisOrientation {
  private ThesisOrientation() {}

  /**
   * The orientation as an X3D SFRotation.
   *
   * @param heading about Y, in degrees
   * @param attitude about Z, in degrees
   * @param bank about X, in degrees
   * @return axis x, y, z and angle in radians; axis 1 0 0 when the angle is 0
   */
  static double[] of(double heading, double attitude, double bank) {
    double c1 = Math.cos(Math.toRadians(heading) / 2);
    double s1 = Math.sin(Math.toRadians(heading) / 2);
    double c2 = Math.cos(Math.toRadians(attitude) / 2);
    double s2 = Math.sin(Math.toRadians(attitude) / 2);
    double c3 = Math.cos(Math.toRadians(bank) / 2);
    double s3 = Math.sin(Math.toRadians(bank) / 2);
    double w = c1 * c2 * c3 - s1 * s2 * s3;
    double x = c1 * c2 * s3 + s1 * s2 * c3;
    double y = s1 * c2 * c3 + c1 * s2 * s3;
    double z = c1 * s2 * c3 - s1 * c2 * s3;
    double norm = Math.sqrt(x * x + y * y + z * z);
    // The listing takes the arc cosine as it is; rounding may put w beyond 1.
    double angle = 2 * Math.acos(Math.max(-1, Math.min(1, w)));
    return norm == 0
        ? new double[] {1, 0, 0, angle}
        : new double[] {x / norm, y / norm, z / norm, angle};
  }
}
