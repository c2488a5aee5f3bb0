package org.selectiverenderer.experiment.window;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.util.Arrays;

/**
 * A monitor as the window system counts it, for windows that Swing opens.
 *
 * @param screen of the window system: 0, except where an X server has several that share nothing
 * @param x its left side on the screen in pixels
 * @param y its upper side in pixels
 * @param width in pixels; 0 for wherever the desktop puts windows
 * @param height in pixels
 */
public record DesktopPlace(int screen, int x, int y, int width, int height) {
  /** Wherever the desktop puts windows. */
  static final DesktopPlace USUAL = new DesktopPlace(0, 0, 0, 0, 0);

  /** The screen that a window is to be opened on. */
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

  /** Where windows may lie on it, in Swing's units. */
  Rectangle area() {
    if (width == 0) {
      return GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    }
    AffineTransform scale = configuration().getDefaultTransform();
    return new Rectangle(
        (int) Math.round(x / scale.getScaleX()),
        (int) Math.round(y / scale.getScaleY()),
        (int) Math.round(width / scale.getScaleX()),
        (int) Math.round(height / scale.getScaleY()));
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
