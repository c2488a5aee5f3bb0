package org.selectiverenderer.scriptengine;

import static org.selectiverenderer.scriptengine.ScriptMeter.allocateCharacters;

import java.util.function.UnaryOperator;

/**
 * Changes long texts part by part. The JDK's work grows with the square of the length where
 * characters become several, as in upper case, where their form depends on the word, and where they
 * have many combining marks.
 */
final class TextParts {
  /** The length of a part. */
  static final int LENGTH = 1000;

  private TextParts() {}

  /** Counts the work on a part, at worst. */
  static void work(int length) {
    ScriptMeter.work(1 + ((long) length * length >> 5));
  }

  /** Returns a text of which each part has been changed. */
  static String change(String text, UnaryOperator<String> change) {
    if (text.length() <= LENGTH) {
      work(text.length());
      return change.apply(text);
    }
    allocateCharacters(text.length());
    StringBuilder changed = new StringBuilder(text.length());
    for (int at = 0; at < text.length(); ) {
      int end = end(text, at);
      work(end - at);
      MeteredMethods.append(changed, change.apply(text.substring(at, end)));
      at = end;
    }
    return MeteredMethods.toString(changed);
  }

  /** Returns the end of a part: that of a word, or else before a letter, where it has none. */
  private static int end(String text, int from) {
    int last = from + LENGTH;
    if (last >= text.length()) {
      return text.length();
    }
    int beforeLetter = last;
    for (int at = last; at > last - LENGTH / 2; at--) {
      if (Character.isLetter(text.charAt(at))) {
        if (!Character.isLetter(text.charAt(at - 1)) && !isMark(text.charAt(at - 1))) {
          return at;
        }
        if (beforeLetter == last) {
          beforeLetter = at;
        }
      }
    }
    return Character.isLowSurrogate(text.charAt(beforeLetter)) ? beforeLetter - 1 : beforeLetter;
  }

  private static boolean isMark(char character) {
    return switch (Character.getType(character)) {
      case Character.NON_SPACING_MARK,
          Character.COMBINING_SPACING_MARK,
          Character.ENCLOSING_MARK,
          Character.FORMAT,
          Character.SURROGATE ->
          true;
      default -> false;
    };
  }
}
