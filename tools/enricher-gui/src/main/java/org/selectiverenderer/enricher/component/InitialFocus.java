package org.selectiverenderer.enricher.component;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JDialog;
import javax.swing.LayoutFocusTraversalPolicy;

/**
 * Shows a modal dialog with the keyboard in the field that is filled in first. The field gets every
 * key that was typed from the moment that the dialog was asked for, also those that arrived before
 * it was on the screen.
 */
public final class InitialFocus {
  private InitialFocus() {}

  /**
   * Shows a modal dialog and waits until it is closed.
   *
   * @param field the component in the dialog that gets the focus
   */
  public static void show(JDialog dialog, Component field) {
    dialog.setFocusTraversalPolicy(new FirstField(field));
    dialog.addWindowFocusListener(
        new WindowAdapter() {
          @Override
          public void windowGainedFocus(WindowEvent event) {
            dialog.removeWindowFocusListener(this);
            field.requestFocusInWindow();
          }
        });
    TypeAheadBuffer keys = TypeAheadBuffer.holdFor(field);
    try {
      dialog.setVisible(true);
    } finally {
      keys.end();
    }
  }

  private static final class FirstField extends LayoutFocusTraversalPolicy {
    private static final long serialVersionUID = 1L;

    private final transient Component field;

    FirstField(Component field) {
      this.field = field;
    }

    @Override
    public Component getInitialComponent(Window window) {
      return field;
    }

    @Override
    public Component getDefaultComponent(Container container) {
      return field;
    }
  }
}
