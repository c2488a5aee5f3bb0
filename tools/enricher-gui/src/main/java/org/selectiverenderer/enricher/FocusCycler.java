package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTree;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.SwingUtilities;
import org.selectiverenderer.enricher.component.AccessibleCanvas;

/** Moves the keyboard focus from pane to pane of a window (F6). */
record FocusCycler(List<Container> parts) {
  /**
   * Puts the focus into the pane after the one that has it; a pane without focusable components is
   * skipped.
   */
  void next() {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    int now = 0;
    for (int i = 0; i < parts.size(); i++) {
      if (owner != null && SwingUtilities.isDescendingFrom(owner, parts.get(i))) {
        now = i + 1;
      }
    }
    Stream<Container> behind = parts.subList(now, parts.size()).stream();
    Stream<Container> before = parts.subList(0, now).stream();
    Stream.concat(behind, before)
        .flatMap(part -> Stream.concat(main(part), controls(part)).limit(1))
        .findFirst()
        .ifPresent(Component::requestFocusInWindow);
  }

  /** The main component of a pane: its tree, table, text area or picture. */
  private static Stream<Component> main(Container part) {
    return controls(part)
        .filter(
            each ->
                each instanceof JTree
                    || each instanceof JTable
                    || each instanceof JTextArea
                    || each instanceof AccessibleCanvas);
  }

  /** All focusable components of a pane, in the order of its layout. */
  private static Stream<Component> controls(Container part) {
    Stops stops = new Stops();
    return Stream.of(part.getComponents())
        .flatMap(
            each ->
                Stream.concat(
                    Stream.of(each).filter(stops::accept),
                    each instanceof Container more ? controls(more) : Stream.empty()));
  }

  private static final class Stops extends LayoutFocusTraversalPolicy {
    private static final long serialVersionUID = 1L;

    @Override
    public boolean accept(Component component) {
      return component.isShowing() && super.accept(component);
    }
  }
}
