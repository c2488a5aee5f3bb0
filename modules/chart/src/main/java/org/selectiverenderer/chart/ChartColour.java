package org.selectiverenderer.chart;

import java.util.Locale;

/**
 * The colours of charts. Those of series also differ in lightness, so that they can be
 * distinguished with any colour vision and in print (Okabe and Ito 2008, Color Universal Design).
 */
public enum ChartColour {
  /** The background. */
  PAPER(0xffffff),
  /** Text and axes. */
  INK(0x222222),
  /** Secondary text. */
  FAINT_INK(0x5a5a5a),
  /** Grid lines. */
  GRID(0xdddddd),
  /** The reference series. */
  GREY(0x999999),
  /** A series. */
  BLUE(0x0072b2),
  /** A series. */
  GREEN(0x009e73),
  /** A series. */
  ORANGE(0xe69f00),
  /** A series. */
  VERMILION(0xd55e00),
  /** A series. */
  SKY(0x56b4e9),
  /** A series. */
  PURPLE(0xcc79a7);

  private final int rgb;

  ChartColour(int rgb) {
    this.rgb = rgb;
  }

  /** Returns the colour as 0xRRGGBB. */
  public int rgb() {
    return rgb;
  }

  /** Returns the colour as SVG writes it, such as {@code #0072b2}. */
  public String hex() {
    return String.format(Locale.ROOT, "#%06x", rgb);
  }
}
