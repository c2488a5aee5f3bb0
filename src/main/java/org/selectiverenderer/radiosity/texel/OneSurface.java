package org.selectiverenderer.radiosity.texel;

/** Whether what is known at one place says anything of another: they may lie on one surface. */
final class OneSurface {
  /** Cosine of the angle between normals from which on a record says nothing. */
  static final double TURNED = 0.85;

  /** How far before or behind of a record's plane, in its radius, a place may lie. */
  private static final double ABOVE = 0.15;

  /** Of places on flat triangles: by how much more than normals turn they may rise, as a slope. */
  private static final double STEP = 0.01;

  private OneSurface() {}

  /**
   * Whether a surface with these normals may pass through both places. On triangles that are shaded
   * flat normals say how the surface goes: it rises by no more than they turn on the way, else
   * there is a step in between, as from a wall to a sheet behind its skirting board. Interpolated
   * normals leave their triangles, so there more is allowed.
   *
   * @param dx with {@code dy} and {@code dz} from one place to the other
   * @param nx with {@code ny} and {@code nz} unit normal
   * @param ox with {@code oy} and {@code oz} unit normal of the other
   * @param flat whether both are shaded flat
   * @param radius within which one of them counts
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
