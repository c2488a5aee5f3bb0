package org.selectiverenderer.enricher;

import java.awt.Frame;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import javax.swing.JFrame;
import org.selectiverenderer.enricher.settings.EnricherSettings;

/** Stores the bounds of the window in the settings and restores them at the next start. */
final class WindowBoundsStore {
  private static final int WIDTH = 1280;
  private static final int HEIGHT = 860;

  /** Pixels of the title bar that must be on a screen so that the window can be dragged. */
  private static final int HOLD = 80;

  private final EnricherSettings settings;

  WindowBoundsStore(EnricherSettings settings) {
    this.settings = settings;
  }

  /**
   * Restores the bounds, no larger than the screens that they are on; centres the window if they
   * are on no screen any more.
   */
  void restore(JFrame frame) {
    Rectangle screen = usable(frame.getGraphicsConfiguration());
    int width = settings.number("window.width", WIDTH);
    int height = settings.number("window.height", HEIGHT);
    Rectangle before =
        new Rectangle(
            settings.number("window.x", Integer.MIN_VALUE),
            settings.number("window.y", Integer.MIN_VALUE),
            width,
            height);
    Rectangle screens = screensOf(before);
    Rectangle middle =
        new Rectangle(
            screen.x + (screen.width - width) / 2,
            screen.y + (screen.height - height) / 2,
            width,
            height);
    // Size and location at once: for a window that the system knows already, an earlier size may
    // come back in between, and the window would be centred by it.
    frame.setBounds(screens.isEmpty() ? within(middle, screen) : within(before, screens));
    if (settings.flag("window.maximized", false)) {
      frame.setExtendedState(Frame.MAXIMIZED_BOTH);
    }
  }

  /** The bounds, made smaller and moved until they lie in an area. */
  private static Rectangle within(Rectangle bounds, Rectangle area) {
    int width = Math.min(bounds.width, area.width);
    int height = Math.min(bounds.height, area.height);
    return new Rectangle(
        Math.max(area.x, Math.min(bounds.x, area.x + area.width - width)),
        Math.max(area.y, Math.min(bounds.y, area.y + area.height - height)),
        width,
        height);
  }

  /** What can be used of the screens that show enough of a window's title bar; empty for none. */
  private static Rectangle screensOf(Rectangle window) {
    Rectangle title = new Rectangle(window.x, window.y, window.width, HOLD);
    Rectangle all = new Rectangle();
    for (GraphicsDevice screen :
        GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices()) {
      GraphicsConfiguration configuration = screen.getDefaultConfiguration();
      Rectangle common = configuration.getBounds().intersection(title);
      if (common.width >= HOLD && common.height >= HOLD / 2) {
        all = all.isEmpty() ? usable(configuration) : all.union(usable(configuration));
      }
    }
    return all;
  }

  /** A screen without the bars of the desktop. */
  private static Rectangle usable(GraphicsConfiguration screen) {
    Rectangle bounds = screen.getBounds();
    Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(screen);
    return new Rectangle(
        bounds.x + bars.left,
        bounds.y + bars.top,
        bounds.width - bars.left - bars.right,
        bounds.height - bars.top - bars.bottom);
  }

  /** Stores the bounds; of a maximized window those that it had before. */
  void remember(JFrame frame) {
    boolean maximized = (frame.getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH;
    settings.put("window.maximized", maximized);
    if (!maximized) {
      settings.put("window.x", frame.getX());
      settings.put("window.y", frame.getY());
      settings.put("window.width", frame.getWidth());
      settings.put("window.height", frame.getHeight());
    }
  }
}
