package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Container;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;

/**
 * Has commands with Ctrl+Alt and a letter not type the letter too. Text components take Ctrl+Alt
 * for AltGr, which types characters such as @ on some keyboards, and so type whatever comes of it.
 */
final class AcceleratorTypingFilter implements KeyEventDispatcher {
  private static final int CTRL_ALT = InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK;

  private final JMenuBar menus;
  private Optional<KeyStroke> pressed = Optional.empty();

  private AcceleratorTypingFilter(JMenuBar menus) {
    this.menus = menus;
  }

  /**
   * Installs the filter for the commands of a menu bar.
   *
   * @return removes it
   */
  static Runnable install(JMenuBar menus) {
    AcceleratorTypingFilter filter = new AcceleratorTypingFilter(menus);
    KeyboardFocusManager keyboard = KeyboardFocusManager.getCurrentKeyboardFocusManager();
    keyboard.addKeyEventDispatcher(filter);
    return () -> keyboard.removeKeyEventDispatcher(filter);
  }

  @Override
  public boolean dispatchKeyEvent(KeyEvent event) {
    boolean both = (event.getModifiersEx() & CTRL_ALT) == CTRL_ALT;
    if (event.getID() == KeyEvent.KEY_PRESSED) {
      pressed = both ? Optional.of(KeyStroke.getKeyStrokeForEvent(event)) : Optional.empty();
    }
    return event.getID() == KeyEvent.KEY_TYPED
        && both
        && pressed.filter(stroke -> isAccelerator(menus, stroke)).isPresent();
  }

  private static boolean isAccelerator(Container in, KeyStroke stroke) {
    Component[] items = in instanceof JMenu menu ? menu.getMenuComponents() : in.getComponents();
    for (Component item : items) {
      boolean its =
          item instanceof JMenuItem command
              && !(item instanceof JMenu)
              && stroke.equals(command.getAccelerator());
      if (its || item instanceof JMenu menu && isAccelerator(menu, stroke)) {
        return true;
      }
    }
    return false;
  }
}
