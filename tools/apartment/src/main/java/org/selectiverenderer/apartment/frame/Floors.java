package org.selectiverenderer.apartment.frame;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Sheet;

/** Builds floors and ceilings as flat rectangles. */
final class Floors {
  /** Distance that the floor extends under the walls, to their middles, metres. */
  private static final double UNDER = 0.06;

  /** Overlap with the walls so that no crack shows, metres. */
  private static final double TOUCH = 0.002;

  private Floors() {}

  /** Returns the floor, two triangles; boards and tiles are a texture. */
  static TriangleMesh floor(Room room) {
    return rectangle(room.west() - UNDER, Room.NORTH, room.east() + UNDER, Room.SOUTH);
  }

  /**
   * Returns the ceiling, which faces down.
   *
   * @param bare whether it ends at the walls: the part inside of them is never visible and would
   *     take facets of the radiosity mesh
   */
  static TriangleMesh ceiling(Room room, boolean bare) {
    double over = bare ? TOUCH : UNDER;
    return rectangle(room.west() - over, Room.NORTH - over, room.east() + over, Room.SOUTH + over)
        .move(0, Room.CEILING, 0)
        .flip();
  }

  private static TriangleMesh rectangle(double west, double north, double east, double south) {
    return Sheet.field(east - west, south - north, 1, 1, (x, z) -> 0)
        .move((west + east) / 2, 0, (north + south) / 2);
  }
}
