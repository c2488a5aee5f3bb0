package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.beans.PropertyChangeListener;
import java.util.List;
import java.util.Optional;
import javax.swing.Action;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;

/**
 * Lets Cut, Copy, Paste and Delete of a menu act on what has the focus: a menu item does what its
 * key does there, for example in a text field.
 */
final class FocusedKeys {
  private static final String OWNER = "permanentFocusOwner";

  private final JComponent content;
  private final List<JComponent> nodeViews;
  private final PropertyChangeListener following = event -> follow(event.getNewValue());
  private @Nullable Component owner;

  /**
   * @param content outside of which a focus does not count, such as that of a menu
   * @param nodeViews the views whose keys act on the selected nodes
   */
  FocusedKeys(JComponent content, List<JComponent> nodeViews) {
    this.content = content;
    this.nodeViews = List.copyOf(nodeViews);
    manager().addPropertyChangeListener(OWNER, following);
  }

  private static KeyboardFocusManager manager() {
    return KeyboardFocusManager.getCurrentKeyboardFocusManager();
  }

  private void follow(@Nullable Object now) {
    if (now instanceof Component component && SwingUtilities.isDescendingFrom(component, content)) {
      owner = component;
    }
  }

  /**
   * Does what a key does in the component that has the focus.
   *
   * @return false if it does nothing there, so that it concerns the selected nodes
   */
  boolean act(KeyStroke key) {
    Optional<JComponent> at = focused();
    for (Component each = at.orElse(null);
        each != null && each != content;
        each = each.getParent()) {
      if (each instanceof JComponent component) {
        Optional<Action> action = action(component, key, each == at.get());
        if (action.isPresent()) {
          action
              .get()
              .actionPerformed(new ActionEvent(component, ActionEvent.ACTION_PERFORMED, ""));
          return true;
        }
      }
    }
    return false;
  }

  private Optional<JComponent> focused() {
    return owner instanceof JComponent component && component.isShowing()
        ? Optional.of(component)
        : Optional.empty();
  }

  private static Optional<Action> action(JComponent component, KeyStroke key, boolean itself) {
    int[] conditions =
        itself
            ? new int[] {JComponent.WHEN_FOCUSED, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT}
            : new int[] {JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT};
    for (int condition : conditions) {
      InputMap keys = component.getInputMap(condition);
      Object name = keys.get(key);
      Action action = name == null ? null : component.getActionMap().get(name);
      if (action != null && action.isEnabled()) {
        return Optional.of(action);
      }
    }
    return Optional.empty();
  }

  /**
   * Whether a key was pressed in a part of the window whose keys do not concern nodes, such as a
   * choice in a form: there a slip must not delete a node.
   */
  boolean elsewhere(KeyStroke key) {
    boolean pressed =
        EventQueue.getCurrentEvent() instanceof KeyEvent event
            && event.getKeyCode() == key.getKeyCode();
    return pressed
        && focused()
            .filter(
                at ->
                    nodeViews.stream().noneMatch(view -> SwingUtilities.isDescendingFrom(at, view)))
            .isPresent();
  }

  /** Stops following the focus. */
  void dispose() {
    manager().removePropertyChangeListener(OWNER, following);
  }
}
