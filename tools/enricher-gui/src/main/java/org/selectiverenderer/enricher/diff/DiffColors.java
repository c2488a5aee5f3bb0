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

  private DiffColors() {}

  static Color background(DiffLines.Kind kind) {
    Color plain = UIManager.getColor("List.background");
    return switch (kind) {
      case ADDED -> mix(plain, GREEN);
      case REMOVED -> mix(plain, RED);
      case PLACE -> mix(plain, BLUE);
      case FILE, SAME -> plain;
    };
  }

  private static Color mix(Color plain, Color tint) {
    return new Color(
        mix(plain.getRed(), tint.getRed()),
        mix(plain.getGreen(), tint.getGreen()),
        mix(plain.getBlue(), tint.getBlue()));
  }

  private static int mix(int plain, int tint) {
    return (int) Math.round(plain * (1 - TINT) + tint * TINT);
  }
}
