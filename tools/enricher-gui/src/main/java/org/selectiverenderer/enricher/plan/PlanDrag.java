package org.selectiverenderer.enricher.plan;

import org.selectiverenderer.geometry.Bounds;

/**
 * What a drag over the plan does to a rectangle. Sides are -1, 0 or 1: which edge follows the
 * pointer on that axis, or none; both 0 move it.
 *
 * @param start the rectangle when the drag began
 * @param sideX of X
 * @param sideZ of Z
 * @param x where the drag began
 * @param z likewise
 */
record PlanDrag(Bounds start, int sideX, int sideZ, double x, double z) {
  /** No side becomes shorter than this. */
  static final double LEAST = 0.05;

  /** Keeps a coordinate of an axis, 0 for X and 1 for Z, to something. */
  interface Snapping {
    double at(int axis, double value);

    /** Whether that is a wall, which goes before the grid. */
    default boolean wall(int axis, double value) {
      return false;
    }
  }

  /** The rectangle when the pointer is at a place; heights stay. */
  Bounds at(double nowX, double nowZ, Snapping snap) {
    if (sideX == 0 && sideZ == 0) {
      double dx = shift(0, start.minX(), start.maxX(), nowX - x, snap);
      double dz = shift(1, start.minZ(), start.maxZ(), nowZ - z, snap);
      return new Bounds(
          start.minX() + dx,
          start.minY(),
          start.minZ() + dz,
          start.maxX() + dx,
          start.maxY(),
          start.maxZ() + dz);
    }
    double minX = start.minX();
    double maxX = start.maxX();
    double minZ = start.minZ();
    double maxZ = start.maxZ();
    if (sideX < 0) {
      minX = Math.min(snap.at(0, minX + nowX - x), maxX - LEAST);
    } else if (sideX > 0) {
      maxX = Math.max(snap.at(0, maxX + nowX - x), minX + LEAST);
    }
    if (sideZ < 0) {
      minZ = Math.min(snap.at(1, minZ + nowZ - z), maxZ - LEAST);
    } else if (sideZ > 0) {
      maxZ = Math.max(snap.at(1, maxZ + nowZ - z), minZ + LEAST);
    }
    return new Bounds(minX, start.minY(), minZ, maxX, start.maxY(), maxZ);
  }

  /** By the edge that comes to a wall, else by the one that is kept to something nearer by. */
  private static double shift(int axis, double min, double max, double by, Snapping snap) {
    double low = snap.at(axis, min + by) - min;
    double high = snap.at(axis, max + by) - max;
    boolean lowWall = snap.wall(axis, min + by);
    if (lowWall != snap.wall(axis, max + by)) {
      return lowWall ? low : high;
    }
    return Math.abs(high - by) < Math.abs(low - by) ? high : low;
  }

  /** A new rectangle between two corners. */
  static Bounds between(double x1, double z1, double x2, double z2, double y) {
    return new Bounds(Math.min(x1, x2), y, Math.min(z1, z2), Math.max(x1, x2), y, Math.max(z1, z2));
  }
}
