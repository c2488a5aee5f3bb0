package org.selectiverenderer.swing;

import java.awt.Window;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JRootPane;
import javax.swing.RootPaneContainer;

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

  /**
   * Packs a window that is not shown yet; its native window is made when it is shown. The window
   * keeps its default button, which Swing forgets with the native window.
   */
  public static void pack(Window window) {
    window.pack();
    Optional<JRootPane> root =
        window instanceof RootPaneContainer swing
            ? Optional.of(swing.getRootPane())
            : Optional.empty();
    Optional<JButton> pressedByEnter = root.map(JRootPane::getDefaultButton);
    window.removeNotify();
    root.ifPresent(pane -> pressedByEnter.ifPresent(pane::setDefaultButton));
  }
}
