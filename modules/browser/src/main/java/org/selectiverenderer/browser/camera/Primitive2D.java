package org.selectiverenderer.browser.camera;

import java.util.Arrays;

/**
 * A two-dimensional drawing primitive of an overlay or panel. Colours are 0xAARRGGBB; coordinates
 * are pixels from the upper left corner, +Y down.
 */
public sealed interface Primitive2D {
  /** Returns the primitive moved by that many pixels. */
  Primitive2D moved(double right, double down);

  /**
   * A straight line.
   *
   * @param width the line's width in pixels
   */
  record Line(double x0, double y0, double x1, double y1, double width, int color)
      implements Primitive2D {
    @Override
    public Line moved(double right, double down) {
      return new Line(x0 + right, y0 + down, x1 + right, y1 + down, width, color);
    }
  }

  /**
   * A filled convex polygon.
   *
   * @param corners x and y of each corner in turn; not to be changed
   */
  record Area(double[] corners, int color) implements Primitive2D {
    @Override
    public Area moved(double right, double down) {
      double[] moved = corners.clone();
      for (int at = 0; at + 1 < moved.length; at += 2) {
        moved[at] += right;
        moved[at + 1] += down;
      }
      return new Area(moved, color);
    }

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
   * @param x the left end of the text
   * @param y the base line of the text
   * @param size the font size in pixels
   */
  record Text(String text, double x, double y, double size, int color) implements Primitive2D {
    @Override
    public Text moved(double right, double down) {
      return new Text(text, x + right, y + down, size, color);
    }
  }

  /**
   * An image, stretched to fill an axis-parallel rectangle.
   *
   * @param x the rectangle's left side
   * @param y the rectangle's upper side
   */
  record Picture(ArgbImage pixels, double x, double y, double width, double height)
      implements Primitive2D {
    @Override
    public Picture moved(double right, double down) {
      return new Picture(pixels, x + right, y + down, width, height);
    }
  }

  /** Makes a filled axis-parallel rectangle. */
  static Area rectangle(double x, double y, double width, double height, int color) {
    return new Area(new double[] {x, y, x + width, y, x + width, y + height, x, y + height}, color);
  }
}
