package org.selectiverenderer.app.operator;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.browser.camera.Primitive2D;

/**
 * The labels of a map: each is drawn on a dark background above the map and inside its edges, and
 * is moved down (at the lower edge up) until it overlaps no other label.
 *
 * @param right edge of the map in pixels
 * @param bottom edge of the map in pixels
 */
record MapLabelPlacement(double right, double bottom, List<Label> placed) {
  private static final double SIZE = 12;
  private static final double LINE = 15;

  /** The average width of a letter as a share of its size, rather too large. */
  private static final double WIDTH = 0.62;

  /**
   * A label and its box.
   *
   * @param x left of the box
   * @param y top of the box
   */
  record Label(String text, double x, double y, double width, int color) {
    boolean meets(Label other) {
      return x < other.x + other.width
          && other.x < x + width
          && y < other.y + LINE
          && other.y < y + LINE;
    }

    Label at(double otherX, double otherY) {
      return new Label(text, otherX, otherY, width, color);
    }
  }

  MapLabelPlacement(double right, double bottom) {
    this(right, bottom, new ArrayList<>());
  }

  /** Places a label as near as possible to a point, the upper left corner of its box. */
  void add(String text, double x, double y, int color) {
    double width = WIDTH * SIZE * text.length() + 4;
    Label label =
        new Label(text, Math.min(x, right - width), Math.min(y, bottom - LINE), width, color);
    double step = y > bottom - 2 * LINE ? -LINE : LINE;
    for (int tries = 0; tries <= placed.size(); tries++) {
      Label wanted = label;
      if (placed.stream().noneMatch(wanted::meets)) {
        break;
      }
      label = label.at(label.x, label.y + step);
    }
    placed.add(label);
  }

  void draw(List<Primitive2D> marks) {
    for (Label label : placed) {
      marks.add(Primitive2D.rectangle(label.x, label.y, label.width, LINE, 0xc01c1f23));
      marks.add(
          new Primitive2D.Text(label.text, label.x + 2, label.y + LINE - 3.5, SIZE, label.color));
    }
  }
}
