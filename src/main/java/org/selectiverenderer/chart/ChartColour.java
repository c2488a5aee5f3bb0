package org.selectiverenderer.chart;

import java.util.Locale;

/**
 * The colours of charts. Those of bars differ in lightness too and are told apart by people of any
 * colour vision and in print (Okabe and Ito 2008, Color Universal Design).
 */
public enum ChartColour {
  PAPER(0xffffff),
  INK(0x222222),
  FAINT_INK(0x5a5a5a),
  GRID(0xdddddd),
  GREY(0x999999),
  BLUE(0x0072b2),
  GREEN(0x009e73),
  ORANGE(0xe69f00),
  VERMILION(0xd55e00),
  SKY(0x56b4e9),
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
