package org.selectiverenderer.enricher.preview;

import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.Map;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.selectiverenderer.runtime.walk.MouseButton;
import org.selectiverenderer.runtime.walk.WalkKey;

/** Maps Swing's keys and mouse buttons to those of navigation. */
final class WalkKeys {
  private static final Map<Integer, WalkKey> KEYS =
      Map.ofEntries(
          Map.entry(KeyEvent.VK_UP, WalkKey.UP),
          Map.entry(KeyEvent.VK_DOWN, WalkKey.DOWN),
          Map.entry(KeyEvent.VK_LEFT, WalkKey.LEFT),
          Map.entry(KeyEvent.VK_RIGHT, WalkKey.RIGHT),
          Map.entry(KeyEvent.VK_W, WalkKey.W),
          Map.entry(KeyEvent.VK_A, WalkKey.A),
          Map.entry(KeyEvent.VK_S, WalkKey.S),
          Map.entry(KeyEvent.VK_D, WalkKey.D),
          Map.entry(KeyEvent.VK_E, WalkKey.E),
          Map.entry(KeyEvent.VK_Q, WalkKey.Q),
          Map.entry(KeyEvent.VK_SHIFT, WalkKey.SHIFT),
          Map.entry(KeyEvent.VK_HOME, WalkKey.HOME),
          Map.entry(KeyEvent.VK_END, WalkKey.END),
          Map.entry(KeyEvent.VK_PAGE_UP, WalkKey.PAGE_UP),
          Map.entry(KeyEvent.VK_PAGE_DOWN, WalkKey.PAGE_DOWN),
          Map.entry(KeyEvent.VK_F2, WalkKey.F2),
          Map.entry(KeyEvent.VK_F3, WalkKey.F3),
          Map.entry(KeyEvent.VK_F5, WalkKey.F5));

  private WalkKeys() {}

  static Optional<WalkKey> key(KeyEvent event) {
    return Optional.ofNullable(KEYS.get(event.getKeyCode()));
  }

  static MouseButton button(MouseEvent event) {
    if (SwingUtilities.isLeftMouseButton(event)) {
      return MouseButton.LEFT;
    }
    return SwingUtilities.isMiddleMouseButton(event) ? MouseButton.MIDDLE : MouseButton.RIGHT;
  }
}
