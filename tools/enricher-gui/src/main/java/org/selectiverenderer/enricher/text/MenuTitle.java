package org.selectiverenderer.enricher.text;

import java.awt.event.KeyEvent;

/**
 * What a menu shows for a command.
 *
 * @param words without the sign
 * @param letter the key that chooses it, a {@code VK_} code of {@link KeyEvent}; {@link
 *     KeyEvent#VK_UNDEFINED} for none
 */
public record MenuTitle(String words, int letter) {
  private static final char SIGN = '&';

  /** Of a text with {@code &} before the letter that chooses the command. */
  public static MenuTitle of(String text) {
    int sign = text.indexOf(SIGN);
    boolean chosen = sign >= 0 && sign + 1 < text.length();
    return new MenuTitle(
        text.replace(String.valueOf(SIGN), ""),
        chosen ? KeyEvent.getExtendedKeyCodeForChar(text.charAt(sign + 1)) : KeyEvent.VK_UNDEFINED);
  }
}
