package org.selectiverenderer.apartment.plan;

import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * The four walls of a room, north being -z. Meshes at a wall are built in the wall's own
 * coordinates: x to the right for a viewer who faces the wall, y up, z into the room from the
 * wall's face.
 */
public enum WallSide {
  NORTH(0, 1),
  EAST(-90, 1),
  SOUTH(180, -1),
  WEST(90, -1);

  private final double yaw;
  private final int sign;

  WallSide(double yaw, int sign) {
    this.yaw = yaw;
    this.sign = sign;
  }

  /**
   * Returns the yaw of an object with its back to the wall, degrees; at yaw 0 its front faces +z.
   */
  public double yaw() {
    return yaw;
  }

  /** Returns whether the wall runs along x. */
  public boolean alongX() {
    return this == NORTH || this == SOUTH;
  }

  /**
   * Converts a position along the wall between world coordinates (x or z) and the wall's x; the
   * function is its own inverse.
   */
  public double across(double along) {
    return sign * along;
  }

  /** Returns the world z or x of the wall's face. */
  public double face(Room room) {
    return switch (this) {
      case NORTH -> Room.NORTH;
      case SOUTH -> Room.SOUTH;
      case EAST -> room.east();
      case WEST -> room.west();
    };
  }

  /** Transforms a mesh from the wall's coordinates to the room's. */
  public TriangleMesh place(Room room, TriangleMesh mesh) {
    double face = face(room);
    return mesh.turnY(yaw).move(alongX() ? 0 : face, 0, alongX() ? face : 0);
  }
}
