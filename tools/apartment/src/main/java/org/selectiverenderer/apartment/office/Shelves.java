package org.selectiverenderer.apartment.office;

/**
 * The measures of the office's bookcase, metres: five shelves, each parted by a post in the middle
 * into a left and a right bay. Frame as the {@code bookcase} model's.
 */
final class Shelves {
  /** Of the bookcase outside. */
  public static final double WIDTH = 1.6;

  public static final double HEIGHT = 2.0;
  public static final double DEPTH = 0.32;

  /** Of the shelves' boards and of the walls. */
  public static final double BOARD = 0.024;

  public static final int COUNT = 5;

  /** Free height between a shelf and the board above it. */
  public static final double CLEAR = 0.354;

  /** Free width of a bay. */
  public static final double BAY = (WIDTH - 3 * BOARD) / 2;

  private static final double LOWEST = 0.1;

  private Shelves() {}

  /**
   * Height of a shelf's upper side: 0.1, 0.478, 0.856, 1.234, 1.612.
   *
   * @param shelf 0 is the lowest
   */
  public static double top(int shelf) {
    return LOWEST + shelf * (CLEAR + BOARD);
  }

  /** x of the middle of the left bay; the right one's is the same to the other side. */
  public static double leftBay() {
    return -(BAY + BOARD) / 2;
  }
}
