package org.selectiverenderer.apartment.office;

/**
 * The dimensions of the office's bookcase, metres: five shelves, each divided by a post in the
 * middle into a left and a right bay. Coordinates are those of the {@code bookcase} model.
 */
final class BookcaseDimensions {
  /** Outer dimensions of the bookcase. */
  public static final double WIDTH = 1.6;

  public static final double HEIGHT = 2.0;
  public static final double DEPTH = 0.32;

  /** Thickness of the shelves' boards and of the walls. */
  public static final double BOARD = 0.024;

  public static final int COUNT = 5;

  /** Clear height between a shelf and the board above it. */
  public static final double CLEAR = 0.354;

  /** Clear width of a bay. */
  public static final double BAY = (WIDTH - 3 * BOARD) / 2;

  private static final double LOWEST = 0.1;

  private BookcaseDimensions() {}

  /**
   * Returns the height of a shelf's upper side: 0.1, 0.478, 0.856, 1.234, 1.612.
   *
   * @param shelf number of the shelf, 0 is the lowest
   */
  public static double top(int shelf) {
    return LOWEST + shelf * (CLEAR + BOARD);
  }

  /** Returns x of the middle of the left bay; that of the right bay is its negative. */
  public static double leftBay() {
    return -(BAY + BOARD) / 2;
  }
}
