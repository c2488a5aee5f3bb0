package org.selectiverenderer.enricher.table;

import java.awt.Color;

/**
 * Colours that support a symbol and can be told apart with red-green colour blindness: blue and
 * vermilion of M. Okabe and K. Ito, Color Universal Design (2008). For light and dark backgrounds
 * alike; text on a tint stays readable.
 */
public final class StatusColors {
  /** Within the limit; consistent. */
  public static final Color CALM = new Color(0x00, 0x72, 0xb2);

  /** Beyond the limit; inconsistent. */
  public static final Color ALERT = new Color(0xd5, 0x5e, 0x00);

  /** Neither of both, such as part of any place. */
  public static final Color NEUTRAL = new Color(0x80, 0x80, 0x80);

  private static final double TINT = 0.28;

  private StatusColors() {}

  /** Returns a background mixed with some of a colour. */
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
