package org.selectiverenderer.apartment.plan;

/**
 * The position of an object in a room, relative to the floor, a wall, the ceiling or another
 * object; {@link PlacementResolver} computes the coordinates. Metres and degrees; yaw turns
 * counter-clockwise seen from above, 0 shows the front to the south.
 */
public sealed interface RoomPosition {

  /** On the floor. */
  record Floor(double x, double z, double yaw) implements RoomPosition {}

  /**
   * On the floor with its back to a wall.
   *
   * @param along x or z of the object's middle in world coordinates
   * @param gap distance between back and wall
   */
  record Against(WallSide side, double along, double gap) implements RoomPosition {}

  /** Hung on a wall with its back, its lower end at a height above the floor. */
  record Hung(WallSide side, double along, double height) implements RoomPosition {}

  /** Hung from the ceiling. */
  record Ceiling(double x, double z) implements RoomPosition {}

  /**
   * Lowered onto another object, or into it, from a height above the floor until it touches.
   *
   * @param x x in the supporting object's own coordinates, and so are {@code z} and {@code yaw}
   */
  record On(String support, double x, double z, double yaw, double from) implements RoomPosition {}
}
