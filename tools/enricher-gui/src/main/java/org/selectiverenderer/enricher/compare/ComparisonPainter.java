package org.selectiverenderer.enricher.compare;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Optional;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;

/** Paints two pictures and the line between them. Positions are in the component's coordinates. */
public final class ComparisonPainter {
  private static final Color PAPER = new Color(0, 0, 0, 150);
  private static final int PAD = 4;

  /** Distance at which the mouse grabs the line. */
  private static final int NEAR = 6;

  private static final int HANDLE = 9;

  private double line = 0.5;

  /** Position of the line as a share of the width, from the left. */
  public double line() {
    return line;
  }

  /** Sets the position of the line. */
  public void line(double part) {
    line = Math.max(0, Math.min(1, part));
  }

  /** Whether a mouse press at a position grabs the line. */
  public boolean takes(Optional<ReferenceImage> shown, int x, int width) {
    return shown.filter(other -> other.mode() == CompareMode.WIPE).isPresent()
        && Math.abs(x - line * width) <= NEAR;
  }

  /** The left edge of the preview's own picture in the component. */
  public static int offset(Optional<ReferenceImage> shown, int width) {
    return shown.filter(other -> other.mode() == CompareMode.BESIDE).isPresent() ? width / 2 : 0;
  }

  /** Where the part of the component begins that shows the preview's own picture. */
  public int ownEdge(Optional<ReferenceImage> shown, int width) {
    return shown.filter(other -> other.mode() == CompareMode.WIPE).isPresent()
        ? (int) Math.round(line * width)
        : offset(shown, width);
  }

  /**
   * Paints both pictures, the line and their titles.
   *
   * @param scale pixels of the pictures per unit of the component
   * @param polygons of the scene as the preview shows it
   */
  public void paint(
      Graphics2D g,
      ReferenceImage other,
      BufferedImage own,
      long polygons,
      double scale,
      int width,
      int height) {
    AffineTransform fit = AffineTransform.getScaleInstance(1 / scale, 1 / scale);
    boolean beside = other.mode() == CompareMode.BESIDE;
    int border = ownEdge(Optional.of(other), width);
    if (beside) {
      g.drawImage(other.image(), fit, null);
      AffineTransform moved = AffineTransform.getTranslateInstance(border, 0);
      moved.concatenate(fit);
      g.drawImage(own, moved, null);
    } else {
      g.drawImage(own, fit, null);
      Shape clip = g.getClip();
      g.clipRect(0, 0, border, height);
      g.drawImage(other.image(), fit, null);
      g.setClip(clip);
    }
    border(g, border, height, beside);
    title(
        g,
        Texts.of("compare.all", DecimalFormatter.grouped(other.polygons())),
        border,
        width,
        false);
    title(g, Texts.of("compare.own", DecimalFormatter.grouped(polygons)), border, width, true);
  }

  private static void border(Graphics2D g, int x, int height, boolean fixed) {
    g.setColor(Color.BLACK);
    g.setStroke(new BasicStroke(3));
    g.drawLine(x, 0, x, height);
    g.setColor(Color.WHITE);
    g.setStroke(new BasicStroke(1));
    g.drawLine(x, 0, x, height);
    if (!fixed) {
      int y = height / 2;
      g.fillOval(x - HANDLE, y - HANDLE, 2 * HANDLE, 2 * HANDLE);
      g.setColor(Color.BLACK);
      g.setStroke(new BasicStroke(1.5f));
      g.drawOval(x - HANDLE, y - HANDLE, 2 * HANDLE, 2 * HANDLE);
      g.drawLine(x - 5, y, x - 2, y - 3);
      g.drawLine(x - 5, y, x - 2, y + 3);
      g.drawLine(x + 5, y, x + 2, y - 3);
      g.drawLine(x + 5, y, x + 2, y + 3);
    }
  }

  /** Paints a title at the top on its side of the border; omits it where there is no room. */
  private static void title(Graphics2D g, String text, int border, int width, boolean right) {
    FontMetrics metrics = g.getFontMetrics();
    int wide = metrics.stringWidth(text) + 2 * PAD;
    int room = right ? width - border : border;
    if (wide + 2 * PAD > room) {
      return;
    }
    int x = right ? border + 2 * PAD : border - wide - 2 * PAD;
    g.setColor(PAPER);
    g.fillRoundRect(x, PAD, wide, metrics.getHeight() + PAD, PAD, PAD);
    g.setColor(Color.WHITE);
    g.drawString(text, x + PAD, PAD + PAD / 2 + metrics.getAscent());
  }
}
