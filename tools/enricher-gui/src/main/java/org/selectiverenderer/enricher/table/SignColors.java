package org.selectiverenderer.enricher.table;

import java.awt.Color;

/**
 * Colours that say something beside a sign, told apart by people who do not tell red from green:
 * blue and vermilion of M. Okabe and K. Ito, Color Universal Design (2008). On light and dark
 * grounds alike, of which a tint leaves the text readable.
 */
public final class SignColors {
  /** As it should be; consistent. */
  public static final Color CALM = new Color(0x00, 0x72, 0xb2);

  /** Not as it should be; inconsistent. */
  public static final Color ALERT = new Color(0xd5, 0x5e, 0x00);

  /** Neither. */
  public static final Color NEUTRAL = new Color(0x80, 0x80, 0x80);

  private static final double TINT = 0.28;

  private SignColors() {}

  /** A ground with a bit of a colour. */
  public static Color tint(Color ground, Color with) {
    return new Color(
        mix(ground.getRed(), with.getRed()),
        mix(ground.getGreen(), with.getGreen()),
        mix(ground.getBlue(), with.getBlue()));
  }

  private static int mix(int ground, int with) {
    return (int) Math.round(ground * (1 - TINT) + with * TINT);
  }
}
