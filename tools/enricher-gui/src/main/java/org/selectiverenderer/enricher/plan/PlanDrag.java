package org.selectiverenderer.enricher.plan;

import org.selectiverenderer.geometry.BoundingBox;

/**
 * A drag in the plan that moves or resizes a rectangle. For each axis -1 or 1 says that the lesser
 * or greater edge follows the pointer, 0 that none does; both 0 move the rectangle.
 *
 * @param start the rectangle when the drag began
 * @param sideX the edge on the X axis
 * @param sideZ the edge on the Z axis
 * @param x world X at which the drag began
 * @param z world Z at which the drag began
 */
record PlanDrag(BoundingBox start, int sideX, int sideZ, double x, double z) {
  /** Least length of a side in metres. */
  static final double LEAST = 0.05;

  /** Snaps a coordinate on an axis, 0 for X and 1 for Z, to a wall or the grid. */
  interface Snapping {
    double at(int axis, double value);

    /** Whether the coordinate snaps to a wall, which has priority over the grid. */
    default boolean wall(int axis, double value) {
      return false;
    }
  }

  /** Returns the rectangle for a pointer position; heights stay. */
  BoundingBox at(double nowX, double nowZ, Snapping snap) {
    if (sideX == 0 && sideZ == 0) {
      double dx = shift(0, start.minX(), start.maxX(), nowX - x, snap);
      double dz = shift(1, start.minZ(), start.maxZ(), nowZ - z, snap);
      return new BoundingBox(
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
    return new BoundingBox(minX, start.minY(), minZ, maxX, start.maxY(), maxZ);
  }

  /**
   * Returns the shift that snaps the edge that meets a wall, else the edge that is nearer to its
   * snapping coordinate.
   */
  private static double shift(int axis, double min, double max, double by, Snapping snap) {
    double low = snap.at(axis, min + by) - min;
    double high = snap.at(axis, max + by) - max;
    boolean lowWall = snap.wall(axis, min + by);
    if (lowWall != snap.wall(axis, max + by)) {
      return lowWall ? low : high;
    }
    return Math.abs(high - by) < Math.abs(low - by) ? high : low;
  }

  /** Returns a new rectangle between two corners. */
  static BoundingBox between(double x1, double z1, double x2, double z2, double y) {
    return new BoundingBox(
        Math.min(x1, x2), y, Math.min(z1, z2), Math.max(x1, x2), y, Math.max(z1, z2));
  }
}
