package org.selectiverenderer.enricher.preview;

import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.Map;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.selectiverenderer.runtime.navigation.Key;
import org.selectiverenderer.runtime.navigation.MouseButton;

/** Swing's keys and buttons as those of navigation. */
final class WalkKeys {
  private static final Map<Integer, Key> KEYS =
      Map.ofEntries(
          Map.entry(KeyEvent.VK_UP, Key.UP),
          Map.entry(KeyEvent.VK_DOWN, Key.DOWN),
          Map.entry(KeyEvent.VK_LEFT, Key.LEFT),
          Map.entry(KeyEvent.VK_RIGHT, Key.RIGHT),
          Map.entry(KeyEvent.VK_W, Key.W),
          Map.entry(KeyEvent.VK_A, Key.A),
          Map.entry(KeyEvent.VK_S, Key.S),
          Map.entry(KeyEvent.VK_D, Key.D),
          Map.entry(KeyEvent.VK_E, Key.E),
          Map.entry(KeyEvent.VK_Q, Key.Q),
          Map.entry(KeyEvent.VK_SHIFT, Key.SHIFT),
          Map.entry(KeyEvent.VK_HOME, Key.HOME),
          Map.entry(KeyEvent.VK_END, Key.END),
          Map.entry(KeyEvent.VK_PAGE_UP, Key.PAGE_UP),
          Map.entry(KeyEvent.VK_PAGE_DOWN, Key.PAGE_DOWN),
          Map.entry(KeyEvent.VK_F2, Key.F2),
          Map.entry(KeyEvent.VK_F3, Key.F3));

  private WalkKeys() {}

  static Optional<Key> key(KeyEvent event) {
    return Optional.ofNullable(KEYS.get(event.getKeyCode()));
  }

  static MouseButton button(MouseEvent event) {
    if (SwingUtilities.isLeftMouseButton(event)) {
      return MouseButton.LEFT;
    }
    return SwingUtilities.isMiddleMouseButton(event) ? MouseButton.MIDDLE : MouseButton.RIGHT;
  }
}
