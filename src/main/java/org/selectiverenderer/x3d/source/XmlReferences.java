package org.selectiverenderer.x3d.source;

/** References to characters, as attributes hold them. */
final class XmlReferences {
  private XmlReferences() {}

  /** What a part of a text means as an attribute's value (XML 1.0, 3.3.3). */
  static String read(CharSequence text, int from, int to) {
    return read(text, from, to, ' ');
  }

  /**
   * The same with another character in place of each end of a line.
   *
   * @param lineEnd a blank, as XML has it, or {@code \n}
   */
  static String read(CharSequence text, int from, int to, char lineEnd) {
    StringBuilder value = new StringBuilder(to - from);
    for (int i = from; i < to; i++) {
      char c = text.charAt(i);
      if (c == '&') {
        int end = i + 1;
        while (end < to && text.charAt(end) != ';') {
          end++;
        }
        reference(text.subSequence(i + 1, end).toString(), value);
        i = end;
      } else if (c == '\r' && i + 1 < to && text.charAt(i + 1) == '\n') {
        value.append(lineEnd);
        i++;
      } else {
        value.append(c == '\n' || c == '\r' ? lineEnd : c < ' ' ? ' ' : c);
      }
    }
    return value.toString();
  }

  private static void reference(String name, StringBuilder into) {
    switch (name) {
      case "lt" -> into.append('<');
      case "gt" -> into.append('>');
      case "amp" -> into.append('&');
      case "quot" -> into.append('"');
      case "apos" -> into.append('\'');
      default -> {
        try {
          into.appendCodePoint(
              name.startsWith("#x")
                  ? Integer.parseInt(name.substring(2), 16)
                  : Integer.parseInt(name.substring(1)));
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
          into.append('&').append(name).append(';'); // an entity of a DOCTYPE: never expanded
        }
      }
    }
  }
}
