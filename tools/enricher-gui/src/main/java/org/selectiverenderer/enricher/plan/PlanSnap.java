package org.selectiverenderer.enricher.plan;

import java.util.OptionalDouble;
import org.selectiverenderer.enricher.area.PlanPicture;

/** Snaps the edges of areas to the walls of a plan. */
final class PlanSnap {
  /** Least length of a wall segment that counts, in metres. */
  private static final double WALL = 0.2;

  /** Largest slope of a wall that counts as parallel to an axis. */
  private static final double STRAIGHT = 0.01;

  private final float[] walls;

  PlanSnap(PlanPicture picture) {
    walls = picture.walls();
  }

  /**
   * Returns the coordinate of the nearest wall; empty if none is near.
   *
   * @param axis 0 for X, 1 for Z
   * @param value coordinate of the edge on that axis
   * @param across coordinate of the pointer on the other axis
   * @param near largest distance in metres
   */
  OptionalDouble wall(int axis, double value, double across, double near) {
    OptionalDouble best = OptionalDouble.empty();
    double least = near;
    for (int i = 0; i + 3 < walls.length; i += 4) {
      double from = walls[i + axis];
      double to = walls[i + 2 + axis];
      double along = walls[i + 1 - axis];
      double end = walls[i + 3 - axis];
      double length = Math.abs(end - along);
      double distance = Math.abs((from + to) / 2 - value);
      boolean wall = length >= WALL && Math.abs(to - from) <= STRAIGHT * length;
      boolean here = across >= Math.min(along, end) - 1 && across <= Math.max(along, end) + 1;
      if (wall && here && distance < least) {
        least = distance;
        best = OptionalDouble.of((from + to) / 2);
      }
    }
    return best;
  }
}
