package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.x3d.tessellate.TextMesher;

/**
 * Lays out text and boxes on a panel from top to bottom, and collects the targets that can be
 * chosen.
 */
final class PanelCanvas {
  static final double SMALL = 27;
  static final double PLAIN = 36;
  static final double LARGE = 46;
  static final double MARGIN = 50;

  /** The line spacing as a multiple of the font size. */
  static final double LINE = 1.35;

  static final int INK = 0xFFF0F3F8;
  static final int FAINT = 0xFFAAB4C4;
  static final int SPOT = 0xFFFFD24A;

  private static final int BOX = 0xFF3A4456;
  private static final int MARKED = 0xFF2E6FD8;

  /** The width of the sheet between its margins. */
  static final double ROOM = QuestionPanelRenderer.WIDTH - 2 * MARGIN;

  private final TextMesher mesher = new TextMesher();
  private final List<Primitive2D> marks = new ArrayList<>();
  private final List<PointerTarget> targets = new ArrayList<>();
  private double y;

  /** Starts a new sheet. */
  void begin() {
    marks.clear();
    targets.clear();
    y = MARGIN;
  }

  /** Returns the current vertical position. */
  double y() {
    return y;
  }

  /** Moves the position down. */
  void skip(double units) {
    y += units;
  }

  /** Moves the position down to a point, unless it is below already. */
  void reach(double down) {
    y = Math.max(y, down);
  }

  void add(Primitive2D mark) {
    marks.add(mark);
  }

  List<Primitive2D> marks() {
    return marks;
  }

  List<PointerTarget> targets() {
    return targets;
  }

  /** Draws a box that can be chosen at the current position. */
  void box(double x, double width, double height, boolean on, Runnable choose) {
    targets.add(new PointerTarget(x, y, width, height, choose));
    marks.add(Primitive2D.rectangle(x, y, width, height, on ? MARKED : BOX));
  }

  /** Adds a target at the current position that can be chosen and is not drawn. */
  void target(double x, double width, double height, Runnable choose) {
    targets.add(new PointerTarget(x, y, width, height, choose));
  }

  /** Draws the labels at the ends of a scale below it. */
  void ends(String least, String most) {
    if (least.isEmpty() && most.isEmpty()) {
      return;
    }
    double half = (ROOM - MARGIN) / 2;
    double top = y();
    List<String> left = wrapped(least, SMALL, half);
    List<String> right = wrapped(most, SMALL, half);
    for (int i = 0; i < Math.max(left.size(), right.size()); i++) {
      double below = top + (i + 1) * SMALL * LINE;
      reach(below);
      if (i < left.size()) {
        add(new Primitive2D.Text(left.get(i), MARGIN, below, SMALL, FAINT));
      }
      if (i < right.size()) {
        double x = MARGIN + ROOM - width(right.get(i), SMALL);
        add(new Primitive2D.Text(right.get(i), x, below, SMALL, FAINT));
      }
    }
  }

  /** Draws a centred line in a box, in a smaller font where it would not fit. */
  void label(String label, double x, double width, double most) {
    double size = Math.min(most, most * (width - SMALL / 2) / Math.max(1, width(label, most)));
    marks.add(
        new Primitive2D.Text(
            label, x + (width - width(label, size)) / 2, y + 1.35 * PLAIN, size, INK));
  }

  /** Draws wrapped text at the current position; nothing if it is blank. */
  void text(String text, double size, int color) {
    if (text.isBlank()) {
      return;
    }
    for (String line : wrapped(text, size, ROOM)) {
      y += size * LINE;
      marks.add(new Primitive2D.Text(line, MARGIN, y - size * (LINE - 1), size, color));
    }
  }

  /**
   * Draws lines inside a box.
   *
   * @return the height of the box
   */
  double boxed(List<String> lines) {
    double base = y + PLAIN * 1.15;
    for (String line : lines) {
      marks.add(new Primitive2D.Text(line, 1.5 * MARGIN, base, PLAIN, INK));
      base += PLAIN * LINE;
    }
    return heightOf(lines);
  }

  /** Returns the height of a box around lines. */
  static double heightOf(List<String> lines) {
    return lines.size() * PLAIN * LINE + PLAIN / 2;
  }

  double width(String text, double size) {
    return mesher.metrics(text, FontFamily.SANS, FontStyle.PLAIN, (float) size).width();
  }

  /** Wraps text at word boundaries. */
  List<String> wrapped(String text, double size, double room) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : text.strip().split("\\s+")) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (!line.isEmpty() && width(longer, size) > room) {
        lines.add(line.toString());
        line.setLength(0);
        line.append(word);
      } else {
        line.setLength(0);
        line.append(longer);
      }
    }
    lines.add(line.toString());
    return lines;
  }
}
