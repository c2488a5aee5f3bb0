package org.selectiverenderer.browser.nodes.layout;

import org.selectiverenderer.browser.scene.Node;

/**
 * The horizontal or vertical part of a Layout node (X3D 4.0, 36.4.1), in world units. A value
 * missing in one of its lists is that of the other direction, or the default.
 *
 * @param size the size of the layout rectangle
 * @param middle the centre of the rectangle, relative to the centre of the parent rectangle
 * @param scale the scale of the content; 0 for STRETCH, which takes that of the other direction
 */
record LayoutAxis(double size, double middle, double scale) {
  private static final String WORLD = "WORLD";

  /**
   * The lengths by which a direction is measured.
   *
   * @param above the size of the parent rectangle
   * @param pixel the size of a pixel
   * @param unit the length of the parent's unit; 0 without a parent: then world units and scale are
   *     fractions of the rectangle (36.4.1: FRACTION)
   */
  record Measure(double above, double pixel, double unit) {}

  /**
   * @param direction 0 for the horizontal, 1 for the vertical
   */
  static LayoutAxis of(Node layout, int direction, Measure by) {
    double size = length(layout, "size", "sizeUnits", direction, 1, by);
    double middle =
        aligned(word(layout, "align", direction, "CENTER"), by.above() - size)
            + length(layout, "offset", "offsetUnits", direction, 0, by);
    return new LayoutAxis(
        size, middle, scale(word(layout, "scaleMode", direction, "NONE"), size, by));
  }

  private static double length(
      Node layout, String field, String units, int direction, double missing, Measure by) {
    float[] numbers = layout.floats(field);
    double number =
        numbers.length == 0 ? missing : numbers[Math.min(direction, numbers.length - 1)];
    return switch (word(layout, units, direction, WORLD)) {
      case "PIXEL" -> number * by.pixel();
      case "FRACTION" -> number * by.above();
      default -> number * (by.unit() == 0 ? by.above() : by.unit());
    };
  }

  /**
   * @param free the difference between the sizes of the parent rectangle and this one
   */
  private static double aligned(String align, double free) {
    return switch (align) {
      case "LEFT", "BOTTOM" -> -free / 2;
      case "RIGHT", "TOP" -> free / 2;
      default -> 0;
    };
  }

  private static double scale(String mode, double size, Measure by) {
    return switch (mode) {
      case "PIXEL" -> by.pixel();
      case "FRACTION" -> size;
      case "STRETCH" -> 0;
      default -> by.unit() == 0 ? size : by.unit();
    };
  }

  /**
   * Returns the value for a direction. A single value holds for both directions, except for the
   * alignment, which then is CENTER for the other one.
   */
  private static String word(Node layout, String field, int direction, String missing) {
    String[] words = layout.strings(field);
    if (direction < words.length) {
      return words[direction];
    }
    return words.length == 0 || field.equals("align") ? missing : words[0];
  }
}
