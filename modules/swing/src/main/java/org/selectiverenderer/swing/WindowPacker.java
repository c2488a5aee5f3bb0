package org.selectiverenderer.swing;

import java.awt.Window;

/**
 * Packs a window before it is placed, without making its native window.
 *
 * <p>{@link Window#pack} alone makes the native window, in the corner of the screen. Without a
 * window manager, a late ConfigureNotify event of the X server with that position may reach AWT
 * after the window has moved: AWT then assumes a wrong position, opens menus there, and computes
 * wrong screen coordinates.
 */
public final class WindowPacker {
  private WindowPacker() {}

  /** Packs a window that is not shown yet; its native window is made when it is shown. */
  public static void pack(Window window) {
    window.pack();
    window.removeNotify();
  }
}
