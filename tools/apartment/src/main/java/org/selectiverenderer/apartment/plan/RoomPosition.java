package org.selectiverenderer.apartment.plan;

/**
 * Where an object stands, as one would say it; {@link PlanLayout} finds the numbers. Metres and
 * degrees; yaw turns counter-clockwise seen from above, 0 shows the front to the south.
 */
public sealed interface RoomPosition {

  /** On the floor. */
  record Floor(double x, double z, double yaw) implements RoomPosition {}

  /**
   * On the floor with its back to a wall.
   *
   * @param along the world's x or z of the object's middle
   * @param gap between back and wall
   */
  record Against(Side side, double along, double gap) implements RoomPosition {}

  /** With its back on a wall, its lower end at a height above the floor. */
  record Hung(Side side, double along, double height) implements RoomPosition {}

  /** Under the ceiling, its upper end there. */
  record Ceiling(double x, double z) implements RoomPosition {}

  /**
   * Let down onto another object, or into it, from a height above the floor until it touches.
   *
   * @param x in the supporting object's own frame, and so are z and yaw
   */
  record On(String support, double x, double z, double yaw, double from) implements RoomPosition {}
}
