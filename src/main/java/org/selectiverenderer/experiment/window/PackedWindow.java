package org.selectiverenderer.experiment.window;

import java.awt.Window;

/**
 * Gives a window the size that its content asks for, before it gets its place.
 *
 * <p>{@link Window#pack} alone makes the native window, in the corner of the screen. Where no
 * window manager runs, the X server's late news of that corner may reach AWT after the window has
 * moved: it then stands in one place while AWT takes it to be in the other, opens menus there, and
 * takes screen coordinates from there.
 */
public final class PackedWindow {
  private PackedWindow() {}

  /** Sizes a window that is not shown yet; its native window is made when it is shown. */
  public static void pack(Window window) {
    window.pack();
    window.removeNotify();
  }
}
