package org.selectiverenderer.radiosity.texel;

/**
 * Criterion whether a record at one point is valid at another: both may lie on the same surface.
 */
final class SameSurfaceCriterion {
  /** Cosine of the angle between normals up to which a record is not valid. */
  static final double TURNED = 0.85;

  /**
   * Largest distance of a point from a record's tangent plane, as a share of the record's radius.
   */
  private static final double ABOVE = 0.15;

  /**
   * For points on flat-shaded triangles: tolerance of the slope between them beyond that given by
   * their normals.
   */
  private static final double STEP = 0.01;

  private SameSurfaceCriterion() {}

  /**
   * Returns whether one surface with these normals may pass through both points. On flat-shaded
   * triangles the normals determine the slope of the surface: it rises by no more than they turn on
   * the way; otherwise there is a step in between, as from a wall to a sheet behind its skirting
   * board. Interpolated normals deviate from their triangles, so more is allowed for them.
   *
   * @param dx with {@code dy} and {@code dz} the vector from one point to the other
   * @param nx with {@code ny} and {@code nz} the unit normal at one point
   * @param ox with {@code oy} and {@code oz} the unit normal at the other
   * @param flat whether both points are shaded flat
   * @param radius radius of validity of the record
   */
  static boolean may(
      double dx,
      double dy,
      double dz,
      double nx,
      double ny,
      double nz,
      double ox,
      double oy,
      double oz,
      boolean flat,
      double radius) {
    double cosine = nx * ox + ny * oy + nz * oz;
    if (cosine <= TURNED) {
      return false;
    }
    double above = Math.abs(dx * (nx + ox) + dy * (ny + oy) + dz * (nz + oz));
    if (above > 2 * ABOVE * radius) {
      return false;
    }
    double away = Math.sqrt(dx * dx + dy * dy + dz * dz);
    double turn = Math.sqrt(Math.max(0, 2 - 2 * cosine));
    return !flat || above <= (turn + 2 * STEP) * away;
  }
}
