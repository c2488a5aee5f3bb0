package org.selectiverenderer.runtime.camera;

import java.util.Arrays;

/** Something drawn on a page. Colours are 0xAARRGGBB. */
public sealed interface Mark {

  /**
   * A straight line.
   *
   * @param width in pixels
   */
  record Line(double x0, double y0, double x1, double y1, double width, int color)
      implements Mark {}

  /**
   * A filled convex polygon.
   *
   * @param corners x, y of each in turn; not written to
   */
  record Area(double[] corners, int color) implements Mark {
    @Override
    public boolean equals(Object other) {
      return other instanceof Area area
          && color == area.color
          && Arrays.equals(corners, area.corners);
    }

    @Override
    public int hashCode() {
      return 31 * Arrays.hashCode(corners) + color;
    }
  }

  /**
   * A line of text.
   *
   * @param x of its left end
   * @param y of its base line
   * @param size of the letters in pixels
   */
  record Text(String text, double x, double y, double size, int color) implements Mark {}

  /**
   * A picture, stretched to fill an upright rectangle.
   *
   * @param x of its left side
   * @param y of its upper side
   */
  record Picture(Pixels pixels, double x, double y, double width, double height) implements Mark {}

  /** A filled upright rectangle. */
  static Area rectangle(double x, double y, double width, double height, int color) {
    return new Area(new double[] {x, y, x + width, y, x + width, y + height, x, y + height}, color);
  }
}
