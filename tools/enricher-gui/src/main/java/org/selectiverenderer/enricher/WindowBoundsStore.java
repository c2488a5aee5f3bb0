package org.selectiverenderer.enricher;

import java.awt.Frame;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
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

  /** Restores the bounds; centres the window if they are on no screen any more. */
  void restore(JFrame frame) {
    Rectangle screen = frame.getGraphicsConfiguration().getBounds();
    int width = settings.number("window.width", Math.min(WIDTH, screen.width));
    int height = settings.number("window.height", Math.min(HEIGHT, screen.height));
    Rectangle before =
        new Rectangle(
            settings.number("window.x", Integer.MIN_VALUE),
            settings.number("window.y", Integer.MIN_VALUE),
            width,
            HOLD);
    // Size and location at once: for a window that the system knows already, an earlier size may
    // come back in between, and the window would be centred by it.
    if (shown(before)) {
      frame.setBounds(before.x, before.y, width, height);
    } else {
      int x = screen.x + (screen.width - width) / 2;
      frame.setBounds(x, screen.y + (screen.height - height) / 2, width, height);
    }
    if (settings.flag("window.maximized", false)) {
      frame.setExtendedState(Frame.MAXIMIZED_BOTH);
    }
  }

  private static boolean shown(Rectangle title) {
    for (GraphicsDevice screen :
        GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices()) {
      GraphicsConfiguration configuration = screen.getDefaultConfiguration();
      Rectangle common = configuration.getBounds().intersection(title);
      if (common.width >= HOLD && common.height >= HOLD / 2) {
        return true;
      }
    }
    return false;
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
