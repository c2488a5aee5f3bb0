package org.selectiverenderer.base.markup;

import java.util.Locale;

/**
 * Makes control characters visible, so that text of strangers cannot command a terminal, forge
 * lines, or reorder what is shown: each becomes the letters of its escape, such as {@code \u001b}.
 * These are the controls of C0 and C1, DEL, the separators of lines and paragraphs, and what sets
 * the direction of writing. All other text stays as it is.
 */
public final class ControlCharacterEscaper {
  private ControlCharacterEscaper() {}

  /** Escapes a text that is to stay one line; tabs stay. */
  public static String line(String text) {
    if (text.chars().noneMatch(ControlCharacterEscaper::isControl)) {
      return text;
    }
    StringBuilder line = new StringBuilder(text.length() + 16);
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      line.append(isControl(c) ? escape(c) : String.valueOf(c));
    }
    return line.toString();
  }

  /** Returns the letters that stand for a character, such as {@code \u001b}. */
  public static String escape(int character) {
    return String.format(Locale.ROOT, "\\u%04x", character);
  }

  /** Returns whether a character commands what shows it, other than a tab. */
  public static boolean isControl(int character) {
    return Character.isISOControl(character) && character != '\t'
        || character == 0x2028 // line separator
        || character == 0x2029 // paragraph separator
        || character == 0x061c // Arabic letter mark
        || character == 0x200e // left-to-right mark
        || character == 0x200f // right-to-left mark
        || character >= 0x202a && character <= 0x202e // embeddings and overrides
        || character >= 0x2066 && character <= 0x2069; // isolates
  }
}
