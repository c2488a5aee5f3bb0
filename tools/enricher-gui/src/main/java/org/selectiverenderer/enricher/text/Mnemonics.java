package org.selectiverenderer.enricher.text;

import java.awt.event.KeyEvent;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JLabel;

/**
 * Sets the mnemonics of buttons and labels: texts in the bundles have {@code &} before the letter
 * that chooses them with Alt. Each language has its own letters, which are unique within a menu or
 * dialog.
 */
public final class Mnemonics {
  private Mnemonics() {}

  /** Returns the text without the {@code &}. */
  public static String without(String text) {
    int mark = text.indexOf('&');
    return mark < 0 ? text : text.substring(0, mark) + text.substring(mark + 1);
  }

  /** Returns the key code of the mnemonic; 0 if the text has none. */
  public static int code(String text) {
    int mark = text.indexOf('&');
    return mark < 0 || mark + 1 == text.length()
        ? 0
        : KeyEvent.getExtendedKeyCodeForChar(text.charAt(mark + 1));
  }

  /** Creates a button with a text of a bundle. */
  public static JButton button(String name, Object... arguments) {
    return on(new JButton(), Texts.of(name, arguments));
  }

  /** Creates a label with a text of a bundle. */
  public static JLabel label(String name, Object... arguments) {
    return on(new JLabel(), Texts.of(name, arguments));
  }

  /** Sets text and mnemonic of a button and returns the button. */
  public static <B extends AbstractButton> B on(B button, String text) {
    button.setText(without(text));
    button.setMnemonic(code(text));
    return button;
  }

  /** Sets text and mnemonic of a label and returns the label. */
  public static JLabel on(JLabel label, String text) {
    label.setText(without(text));
    label.setDisplayedMnemonic(code(text));
    return label;
  }
}
