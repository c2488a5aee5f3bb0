package org.selectiverenderer.enricher;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.RenderingHints;
import java.awt.Taskbar;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JFrame;

/**
 * The icon of the program: a ball of which one half has many polygons and the other few. It is
 * drawn in every size that desktops ask for; installers have it as files.
 */
public final class WindowIcon {
  private static final int[] SIZES = {16, 20, 24, 32, 40, 48, 64, 128, 256};
  private static final Color GROUND = new Color(0x1f4e79);
  private static final Color FEW = new Color(0xf2a33a);
  private static final Color MANY = new Color(0xeaf2fa);
  private static final int CORNERS_MANY = 16;
  private static final int CORNERS_FEW = 3;

  private WindowIcon() {}

  /**
   * Sets the icon of a window, and that of the program in the task bar where the system has one.
   */
  static void dress(JFrame frame) {
    List<Image> images = images();
    frame.setIconImages(images);
    if (Taskbar.isTaskbarSupported()
        && Taskbar.getTaskbar().isSupported(Taskbar.Feature.ICON_IMAGE)) {
      Taskbar.getTaskbar().setIconImage(images.get(images.size() - 1));
    }
  }

  static List<Image> images() {
    return IntStream.of(SIZES).<Image>mapToObj(WindowIcon::image).toList();
  }

  /**
   * @param size in pixels
   */
  public static BufferedImage image(int size) {
    BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
    Graphics2D g = image.createGraphics();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    g.scale(size / 32.0, size / 32.0);
    g.setColor(GROUND);
    g.fill(new RoundRectangle2D.Double(0.5, 0.5, 31, 31, 8, 8));
    g.setColor(FEW);
    g.fill(half(CORNERS_FEW, -1));
    g.setColor(MANY);
    g.fill(half(CORNERS_MANY, 1));
    if (size >= 32) {
      g.setColor(GROUND);
      g.setStroke(new BasicStroke(0.8f));
      for (int i = 1; i < CORNERS_MANY; i++) {
        double angle = Math.PI * i / CORNERS_MANY;
        g.draw(new Line2D.Double(16.8, 16, 16.8 + 11 * Math.sin(angle), 16 - 11 * Math.cos(angle)));
      }
    }
    g.dispose();
    return image;
  }

  /**
   * The outline of half a ball about the middle of the icon.
   *
   * @param corners number of segments of its rim
   * @param side 1 for the right one, -1 for the left one
   */
  private static Path2D half(int corners, int side) {
    Path2D half = new Path2D.Double();
    double middle = 16 + side * 0.8;
    half.moveTo(middle, 5);
    for (int i = 1; i <= corners; i++) {
      double angle = Math.PI * i / corners;
      half.lineTo(middle + side * 11 * Math.sin(angle), 16 - 11 * Math.cos(angle));
    }
    half.closePath();
    return half;
  }
}
