package org.selectiverenderer.enricher.diff;

import java.awt.Color;
import javax.swing.UIManager;

/**
 * Background colours of diff lines: the theme's background with a tint on which its text stays
 * readable.
 */
final class DiffColors {
  private static final Color GREEN = new Color(0x2E, 0xA0, 0x43);
  private static final Color RED = new Color(0xF8, 0x51, 0x49);
  private static final Color BLUE = new Color(0x38, 0x8B, 0xFD);
  private static final double TINT = 0.22;
  private static final double MARK = 0.5;

  private DiffColors() {}

  static Color background(DiffLines.Kind kind) {
    return tinted(kind, TINT);
  }

  /** Returns the background of the part of a line that differs. */
  static Color marked(DiffLines.Kind kind) {
    return tinted(kind, MARK);
  }

  private static Color tinted(DiffLines.Kind kind, double tint) {
    Color plain = UIManager.getColor("List.background");
    return switch (kind) {
      case ADDED -> mix(plain, GREEN, tint);
      case REMOVED -> mix(plain, RED, tint);
      case PLACE -> mix(plain, BLUE, tint);
      case FILE, SAME -> plain;
    };
  }

  private static Color mix(Color plain, Color tint, double part) {
    return new Color(
        mix(plain.getRed(), tint.getRed(), part),
        mix(plain.getGreen(), tint.getGreen(), part),
        mix(plain.getBlue(), tint.getBlue(), part));
  }

  private static int mix(int plain, int tint, double part) {
    return (int) Math.round(plain * (1 - part) + tint * part);
  }
}
