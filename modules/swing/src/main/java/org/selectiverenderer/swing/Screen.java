package org.selectiverenderer.swing;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;

/** Finds out whether Swing can show windows. */
public final class Screen {
  private Screen() {}

  /** Returns whether there is a screen. */
  public static boolean exists() {
    try {
      return !GraphicsEnvironment.isHeadless()
          && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
    } catch (AWTError e) {
      return false; // DISPLAY names an X server that does not answer
    }
  }
}
