package org.selectiverenderer.x3d.field;

/** The words of a value: what stands between white space and commas. */
public final class Tokens {
  private static final int QUOTED_LENGTH = 40;

  private Tokens() {}

  /** White space of XML, and the comma, which X3D reads as white space between values. */
  static boolean separates(char c) {
    return c <= ' ' || c == ',';
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

  /** Where the word of that index starts, counted from {@code start}. */
  static int offset(char[] text, int start, int end, int index) {
    int at = skipSeparators(text, start, end);
    for (int i = 0; i < index; i++) {
      at = skipSeparators(text, skipWord(text, at, end), end);
    }
    return at - start;
  }

  /** How many characters of white space a text starts with. */
  public static int leading(String text) {
    int at = 0;
    while (at < text.length() && text.charAt(at) <= ' ') {
      at++;
    }
    return at;
  }

  /** A string as one of an MFString (ISO/IEC 19776-1, 5.15). */
  public static String string(String content) {
    return '"' + content.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }

  /** A word for a message: in quotes, shortened, without what would disturb a terminal. */
  public static String quote(String word) {
    StringBuilder text = new StringBuilder("'");
    word.codePoints()
        .limit(QUOTED_LENGTH)
        .map(c -> Character.isISOControl(c) ? '?' : c)
        .forEach(text::appendCodePoint);
    return text.append(word.length() > QUOTED_LENGTH ? "...'" : "'").toString();
  }
}
