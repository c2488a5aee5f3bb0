package org.selectiverenderer.authoring.creation;

/**
 * The inner size of a room in metres.
 *
 * @param width along x
 * @param depth along z
 * @param height along y
 */
public record RoomSize(double width, double depth, double height) {
  /** The smallest side of a room, in which a viewer of usual size can stand. */
  public static final double LEAST = 1;

  /** The largest side. */
  public static final double MOST = 1000;

  /** The size of a usual room. */
  public static final RoomSize USUAL = new RoomSize(5, 4, 2.6);

  /**
   * Checks the sizes.
   *
   * @throws IllegalArgumentException if one is not between {@link #LEAST} and {@link #MOST}
   */
  public RoomSize {
    if (!sound(width) || !sound(depth) || !sound(height)) {
      throw new IllegalArgumentException(
          "a room is between 1 and 1000 metres wide, deep and high, not %s by %s by %s"
              .formatted(width, depth, height));
    }
  }

  private static boolean sound(double side) {
    return side >= LEAST && side <= MOST;
  }
}
