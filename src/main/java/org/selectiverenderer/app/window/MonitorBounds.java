package org.selectiverenderer.app.window;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.geom.AffineTransform;
import java.util.Arrays;

/**
 * The bounds of a monitor in pixels of the window system, for placing Swing windows.
 *
 * @param screen number of the window system's screen: 0, except on an X server with several
 *     independent screens
 * @param x left edge on the screen in pixels
 * @param y upper edge in pixels
 * @param width in pixels; 0 for the desktop's default placement of windows
 * @param height in pixels
 */
public record MonitorBounds(int screen, int x, int y, int width, int height) {
  /** The desktop's default placement of windows. */
  public static final MonitorBounds USUAL = new MonitorBounds(0, 0, 0, 0, 0);

  /** Returns the graphics configuration for a window on the monitor. */
  GraphicsConfiguration configuration() {
    GraphicsEnvironment desktop = GraphicsEnvironment.getLocalGraphicsEnvironment();
    if (width == 0) {
      return desktop.getDefaultScreenDevice().getDefaultConfiguration();
    }
    GraphicsDevice[] all = desktop.getScreenDevices();
    boolean joined =
        Arrays.stream(all)
                .map(each -> pixels(each.getDefaultConfiguration()).getLocation())
                .distinct()
                .count()
            > 1;
    if (!joined && screen < all.length) {
      return all[screen].getDefaultConfiguration();
    }
    return Arrays.stream(all)
        .map(GraphicsDevice::getDefaultConfiguration)
        .filter(each -> pixels(each).contains(x + width / 2, y + height / 2))
        .findFirst()
        .orElseGet(() -> desktop.getDefaultScreenDevice().getDefaultConfiguration());
  }

  /** Centres a window on the monitor. */
  void center(Window window) {
    Rectangle most = area();
    window.setLocation(
        most.x + (most.width - window.getWidth()) / 2,
        most.y + (most.height - window.getHeight()) / 2);
  }

  /** Returns the monitor's work area, without the desktop's bars, in Swing's units. */
  Rectangle area() {
    if (width == 0) {
      return GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    }
    AffineTransform scale = configuration().getDefaultTransform();
    Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(configuration());
    return new Rectangle(
        (int) Math.round(x / scale.getScaleX()) + bars.left,
        (int) Math.round(y / scale.getScaleY()) + bars.top,
        (int) Math.round(width / scale.getScaleX()) - bars.left - bars.right,
        (int) Math.round(height / scale.getScaleY()) - bars.top - bars.bottom);
  }

  private static Rectangle pixels(GraphicsConfiguration screen) {
    Rectangle bounds = screen.getBounds();
    AffineTransform scale = screen.getDefaultTransform();
    return new Rectangle(
        (int) Math.round(bounds.x * scale.getScaleX()),
        (int) Math.round(bounds.y * scale.getScaleY()),
        (int) Math.round(bounds.width * scale.getScaleX()),
        (int) Math.round(bounds.height * scale.getScaleY()));
  }
}
