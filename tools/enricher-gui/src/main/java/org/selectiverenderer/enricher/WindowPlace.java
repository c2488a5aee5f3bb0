package org.selectiverenderer.enricher;

import java.awt.Frame;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import javax.swing.JFrame;
import org.selectiverenderer.enricher.settings.EnricherSettings;

/** Where a window stands on the desktop, remembered from one start to the next. */
final class WindowPlace {
  private static final int WIDTH = 1280;
  private static final int HEIGHT = 860;

  /** So much of the window must be on a screen that one can get hold of it, in pixels. */
  private static final int HOLD = 80;

  private final EnricherSettings settings;

  WindowPlace(EnricherSettings settings) {
    this.settings = settings;
  }

  /** Puts the window where it was; into the middle if no screen is there any more. */
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
    // Size and place at once: of a window that the system knows already, an earlier size may come
    // back in between, and its middle would be taken for the window's.
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

  /** Remembers where the window is. A maximized one keeps the size that it had before. */
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
