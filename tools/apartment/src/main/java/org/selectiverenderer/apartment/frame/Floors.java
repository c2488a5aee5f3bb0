package org.selectiverenderer.apartment.frame;

import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Sheet;

/** Floors and ceilings: flat rectangles. */
final class Floors {
  /** How far the floor goes on under the walls, to their middles. */
  private static final double UNDER = 0.06;

  /** So far that no crack shows. */
  private static final double TOUCH = 0.002;

  private Floors() {}

  /** The floor, two triangles: boards and tiles are a picture. */
  static TriangleMesh floor(Room room) {
    return rectangle(room.west() - UNDER, Room.NORTH, room.east() + UNDER, Room.SOUTH);
  }

  /**
   * The ceiling, which faces down.
   *
   * @param bare whether it just touches the walls: what reaches into them is never seen, and takes
   *     facets from where light is
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
