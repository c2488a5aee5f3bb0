package org.selectiverenderer.testing.robot;

import java.awt.AWTException;
import java.awt.Robot;

/**
 * Pauses of a robot for which X11 gives no signal.
 *
 * <p>Without a window manager the X server maps, moves and raises a window at some time after the
 * request, may put it elsewhere than AWT believes, and reports neither reliably: AWT's own {@code
 * waitForIdle} returns before. A click in the meantime misses the window. Everything else is
 * awaited by a condition.
 */
public final class DisplaySettling {
  /** Milliseconds that a busy machine needs to show, move or raise a window. */
  private static final int WINDOW = 150;

  /** The same for a window that the code under test opens by itself, on a thread of its own. */
  private static final int OPENED_WINDOW = 400;

  private DisplaySettling() {}

  /** Waits while a window that was shown, moved or raised arrives, and handles its events. */
  public static void awaitWindow() {
    pause(WINDOW);
  }

  /** Waits while a window arrives that the code under test opened, and handles its events. */
  public static void awaitOpenedWindow() {
    pause(OPENED_WINDOW);
  }

  /**
   * Waits for a time that a measurement or a picture is to cover, and handles the events of it.
   *
   * @param milliseconds the time
   */
  public static void pause(int milliseconds) {
    try {
      new Robot().delay(milliseconds);
    } catch (AWTException e) {
      throw new AssertionError(e);
    }
    GuiRobot.onEdt(() -> true);
  }
}
