package org.selectiverenderer.enricher.plan;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The scale bar of the plan: a length of 1, 2 or 5 times a power of ten.
 *
 * @param metres the length
 * @param pixels the length on the screen
 */
record ScaleBar(double metres, double pixels) {
  private static final double SHORTEST = 50;
  private static final int MARGIN = 14;

  /**
   * Returns the bar of a scale.
   *
   * @param scale pixels per metre
   */
  static ScaleBar of(double scale) {
    double least = SHORTEST / scale;
    double power = Math.pow(10, Math.floor(Math.log10(least)));
    for (double digit : new double[] {1, 2, 5}) {
      if (digit * power >= least) {
        return new ScaleBar(digit * power, digit * power * scale);
      }
    }
    return new ScaleBar(10 * power, 10 * power * scale);
  }

  String words() {
    return Texts.of("placement.length", DecimalFormatter.rounded(metres, 6));
  }

  /** Paints the bar at the lower left corner of a component of a height. */
  void paint(Graphics2D g, int height, Color ink, Color paper) {
    FontMetrics metrics = g.getFontMetrics();
    String words = words();
    int y = height - MARGIN;
    int wide = (int) Math.max(pixels, metrics.stringWidth(words));
    g.setColor(new Color(paper.getRed(), paper.getGreen(), paper.getBlue(), 200));
    g.fillRoundRect(
        MARGIN - 6, y - metrics.getHeight() - 8, wide + 12, metrics.getHeight() + 14, 6, 6);
    g.setColor(ink);
    g.setStroke(new BasicStroke(2));
    Path2D bar = new Path2D.Double();
    bar.moveTo(MARGIN, y - 5);
    bar.lineTo(MARGIN, y);
    bar.lineTo(MARGIN + pixels, y);
    bar.lineTo(MARGIN + pixels, y - 5);
    g.draw(bar);
    g.drawString(words, MARGIN + 4, y - 6);
  }
}
