package org.selectiverenderer.enricher.text;

import java.awt.event.KeyEvent;
import org.selectiverenderer.swing.PlainText;

/**
 * The text of a menu item and its mnemonic.
 *
 * @param words the text without {@code &}
 * @param letter the mnemonic, a {@code VK_} code of {@link KeyEvent}; {@link KeyEvent#VK_UNDEFINED}
 *     for none
 */
public record MnemonicText(String words, int letter) {
  private static final char SIGN = '&';

  /** Parses a text with {@code &} before its mnemonic letter. */
  public static MnemonicText of(String text) {
    int sign = text.indexOf(SIGN);
    boolean chosen = sign >= 0 && sign + 1 < text.length();
    return new MnemonicText(
        PlainText.of(text.replace(String.valueOf(SIGN), "")),
        chosen ? KeyEvent.getExtendedKeyCodeForChar(text.charAt(sign + 1)) : KeyEvent.VK_UNDEFINED);
  }
}
