package org.selectiverenderer.apartment.plan;

import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * The walls of a room, north being -z. What stands against a wall is made in the wall's own frame:
 * x to the right as one looks at the wall, y up, z into the room from the wall's face.
 */
public enum Side {
  NORTH(0, 1),
  EAST(-90, 1),
  SOUTH(180, -1),
  WEST(90, -1);

  private final double yaw;
  private final int sign;

  Side(double yaw, int sign) {
    this.yaw = yaw;
    this.sign = sign;
  }

  /** By how much a thing that shows its front to +z is turned to have its back to the wall. */
  public double yaw() {
    return yaw;
  }

  /** Whether the wall runs along x. */
  public boolean alongX() {
    return this == NORTH || this == SOUTH;
  }

  /** The wall frame's x of a place along the wall, given as the world's x or z; and back. */
  public double across(double along) {
    return sign * along;
  }

  /** Where the wall's face is: the world's z or x. */
  public double face(Room room) {
    return switch (this) {
      case NORTH -> Room.NORTH;
      case SOUTH -> Room.SOUTH;
      case EAST -> room.east();
      case WEST -> room.west();
    };
  }

  /** A mesh from the wall's frame to the room's. */
  public TriangleMesh place(Room room, TriangleMesh mesh) {
    double face = face(room);
    return mesh.turnY(yaw).move(alongX() ? 0 : face, 0, alongX() ? face : 0);
  }
}
