package org.selectiverenderer.x3d.write;

/** Converts X3D numbers to JSON syntax (RFC 8259, 6), with the same digits where possible. */
final class JsonNumber {
  private JsonNumber() {}

  /**
   * Appends a number or boolean.
   *
   * @param from the offset of the word
   * @param to the offset after the word
   */
  static void append(StringBuilder into, String text, int from, int to) {
    int at = from;
    char c = text.charAt(at);
    if (c == 't' || c == 'f') {
      into.append(text, from, to);
      return;
    }
    if (c == '-') {
      into.append('-');
    }
    at += c == '-' || c == '+' ? 1 : 0;
    if (text.regionMatches(true, at, "0x", 0, 2)) {
      into.append((int) Long.parseLong(text.substring(at + 2, to), 16));
      return;
    }
    while (at + 1 < to && text.charAt(at) == '0' && digit(text.charAt(at + 1))) {
      at++;
    }
    if (text.charAt(at) == '.') {
      into.append('0');
    }
    for (; at < to; at++) {
      char next = at + 1 < to ? text.charAt(at + 1) : 0;
      if (text.charAt(at) != '.' || digit(next)) {
        into.append(text.charAt(at)); // a decimal point without digits after it is dropped
      }
    }
  }

  private static boolean digit(char c) {
    return c >= '0' && c <= '9';
  }
}
