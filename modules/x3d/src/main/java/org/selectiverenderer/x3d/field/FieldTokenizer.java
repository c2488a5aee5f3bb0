package org.selectiverenderer.x3d.field;

import org.selectiverenderer.base.markup.ControlCharacterEscaper;

/** Splits the text of a value into words separated by white space and commas. */
public final class FieldTokenizer {
  private static final int QUOTED_LENGTH = 40;

  private FieldTokenizer() {}

  /** Returns whether a character is white space or a comma, which X3D treats alike. */
  static boolean separates(char c) {
    return c <= ' ' || c == ',';
  }

  /** Returns the offset after the sign of a number, if it has one. */
  static int skipSign(char[] text, int at) {
    return text[at] == '-' || text[at] == '+' ? at + 1 : at;
  }

  static int skipSeparators(char[] text, int at, int end) {
    while (at < end && separates(text[at])) {
      at++;
    }
    return at;
  }

  static int skipWord(char[] text, int at, int end) {
    while (at < end && !separates(text[at])) {
      at++;
    }
    return at;
  }

  static int count(char[] text, int start, int end) {
    int count = 0;
    for (int at = skipSeparators(text, start, end); at < end; count++) {
      at = skipSeparators(text, skipWord(text, at, end), end);
    }
    return count;
  }

  /** Returns the offset from {@code start} of the word with an index. */
  static int offset(char[] text, int start, int end, int index) {
    int at = skipSeparators(text, start, end);
    for (int i = 0; i < index; i++) {
      at = skipSeparators(text, skipWord(text, at, end), end);
    }
    return at - start;
  }

  /** Returns the number of white space characters at the start of a text. */
  public static int leading(String text) {
    int at = 0;
    while (at < text.length() && text.charAt(at) <= ' ') {
      at++;
    }
    return at;
  }

  /** Quotes a string for an MFString (ISO/IEC 19776-1, 5.15). */
  public static String string(String content) {
    return '"' + content.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }

  /** Quotes a word for a message, shortened and without control characters. */
  public static String quote(String word) {
    StringBuilder text = new StringBuilder("'");
    word.codePoints()
        .limit(QUOTED_LENGTH)
        .map(c -> c == '\t' || ControlCharacterEscaper.isControl(c) ? '?' : c)
        .forEach(text::appendCodePoint);
    return text.append(word.length() > QUOTED_LENGTH ? "...'" : "'").toString();
  }
}
