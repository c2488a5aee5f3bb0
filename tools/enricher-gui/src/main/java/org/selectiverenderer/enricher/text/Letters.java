package org.selectiverenderer.enricher.text;

import java.awt.event.KeyEvent;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JLabel;

/**
 * Texts that have {@code &} before the letter that chooses them with Alt: each language has letters
 * of its own, which are told from each other where they meet.
 */
public final class Letters {
  private Letters() {}

  /** The text as it is shown. */
  public static String without(String text) {
    int mark = text.indexOf('&');
    return mark < 0 ? text : text.substring(0, mark) + text.substring(mark + 1);
  }

  /** The code of the letter's key, as components want it; 0 if the text has none. */
  public static int code(String text) {
    int mark = text.indexOf('&');
    return mark < 0 || mark + 1 == text.length()
        ? 0
        : KeyEvent.getExtendedKeyCodeForChar(text.charAt(mark + 1));
  }

  /** A button with a text of a bundle. */
  public static JButton button(String name, Object... arguments) {
    return on(new JButton(), Texts.of(name, arguments));
  }

  /** A label with a text of a bundle. */
  public static JLabel label(String name, Object... arguments) {
    return on(new JLabel(), Texts.of(name, arguments));
  }

  /** The same button, with a text and its letter. */
  public static <B extends AbstractButton> B on(B button, String text) {
    button.setText(without(text));
    button.setMnemonic(code(text));
    return button;
  }

  /** The same label, with a text and its letter. */
  public static JLabel on(JLabel label, String text) {
    label.setText(without(text));
    label.setDisplayedMnemonic(code(text));
    return label;
  }
}
