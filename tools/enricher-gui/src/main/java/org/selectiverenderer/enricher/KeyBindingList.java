package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javax.swing.Action;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.MenuElement;

/**
 * Collects the keyboard shortcuts of a window from their owners: the actions of its menus and
 * context menus, and the named actions of its components.
 */
final class KeyBindingList {
  /**
   * A shortcut: its key, and what it does.
   *
   * @param part of the window where it works: a menu's title, or the accessible name of a component
   */
  record Entry(String part, String key, String does) {}

  private final Set<Entry> entries = new LinkedHashSet<>();

  private KeyBindingList() {}

  static List<Entry> of(JMenuBar bar, Container content) {
    KeyBindingList list = new KeyBindingList();
    for (int i = 0; i < bar.getMenuCount(); i++) {
      list.menu(bar.getMenu(i), bar.getMenu(i).getText());
    }
    list.parts(content);
    return new ArrayList<>(list.entries);
  }

  private void menu(MenuElement menu, String part) {
    for (MenuElement element : menu.getSubElements()) {
      if (element instanceof JMenuItem item
          && !(item instanceof JMenu)
          && item.getAccelerator() != null) {
        entries.add(new Entry(part, text(item.getAccelerator()), item.getText()));
      }
      menu(element, part);
    }
  }

  private void parts(Container container) {
    for (Component each : container.getComponents()) {
      if (each instanceof JComponent component) {
        actions(component);
        if (component.getComponentPopupMenu() != null) {
          menu(component.getComponentPopupMenu(), name(component));
        }
      }
      if (each instanceof Container more) {
        parts(more);
      }
    }
  }

  private void actions(JComponent component) {
    for (int when :
        new int[] {JComponent.WHEN_FOCUSED, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT}) {
      InputMap keys = component.getInputMap(when);
      KeyStroke[] own = keys == null ? null : keys.keys();
      for (KeyStroke key : own == null ? new KeyStroke[0] : own) {
        Action action = component.getActionMap().get(keys.get(key));
        if (action != null && action.getValue(Action.NAME) instanceof String does) {
          entries.add(new Entry(name(component), text(key), does));
        }
      }
    }
  }

  private static String name(JComponent component) {
    String name = component.getAccessibleContext().getAccessibleName();
    return name == null ? "" : name;
  }

  /** The key as menus write it: {@code Ctrl+Shift+Z}. */
  static String text(KeyStroke key) {
    String modifiers = InputEvent.getModifiersExText(key.getModifiers());
    return (modifiers.isEmpty() ? "" : modifiers + "+") + KeyEvent.getKeyText(key.getKeyCode());
  }
}
