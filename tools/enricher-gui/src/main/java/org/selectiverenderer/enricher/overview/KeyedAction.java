package org.selectiverenderer.enricher.overview;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** An action with a name and an accelerator key, for a menu, a button and the keyboard alike. */
@SuppressWarnings("serial") // never written
final class KeyedAction extends AbstractAction {
  private static final long serialVersionUID = 1L;
  private final Runnable work;

  /**
   * @param key the accelerator as {@link KeyStroke#getKeyStroke(String)} reads it; {@code menu} is
   *     the modifier of menu shortcuts on this system (Ctrl, or Command on macOS)
   */
  KeyedAction(String name, String key, Runnable work) {
    super(name);
    this.work = work;
    putValue(ACCELERATOR_KEY, stroke(key));
  }

  private static KeyStroke stroke(String key) {
    KeyStroke stroke = KeyStroke.getKeyStroke(key.replace("menu ", ""));
    return key.contains("menu ")
        ? KeyStroke.getKeyStroke(
            stroke.getKeyCode(),
            stroke.getModifiers() | Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx())
        : stroke;
  }

  /** Binds the key in a component and all components in it. */
  KeyedAction in(JComponent component) {
    Object key = getValue(ACCELERATOR_KEY);
    component
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put((KeyStroke) key, getValue(NAME));
    component.getActionMap().put(getValue(NAME), this);
    return this;
  }

  @Override
  public void actionPerformed(ActionEvent e) {
    work.run();
  }
}
