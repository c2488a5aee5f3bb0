package org.selectiverenderer.chart;

import java.util.Locale;

/**
 * The colours of charts. Those of bars differ in lightness too and are told apart by people of any
 * colour vision and in print (Okabe and Ito 2008, Color Universal Design).
 */
public enum ChartColour {
  /** Behind everything. */
  PAPER(0xffffff),
  /** Letters and axes. */
  INK(0x222222),
  /** Letters that say less. */
  FAINT_INK(0x5a5a5a),
  /** Lines of values. */
  GRID(0xdddddd),
  /** A series that others are compared with. */
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

  /** 0xRRGGBB. */
  public int rgb() {
    return rgb;
  }

  /** As SVG writes it. */
  public String hex() {
    return String.format(Locale.ROOT, "#%06x", rgb);
  }
}
