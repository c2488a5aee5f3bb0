package org.selectiverenderer.x3d.source;

import java.util.Optional;

/** References to characters, as attributes hold them. */
final class XmlReferences {
  private XmlReferences() {}

  /** What a part of a text means as an attribute's value (XML 1.0, 3.3.3). */
  static String read(CharSequence text, int from, int to) {
    return read(text, from, to, ' ', Entities.NONE);
  }

  /**
   * The same with another character in place of each end of a line.
   *
   * @param lineEnd a blank, as XML has it, or {@code \n}
   * @param entities what other references mean
   */
  static String read(CharSequence text, int from, int to, char lineEnd, Entities entities) {
    StringBuilder value = new StringBuilder(to - from);
    for (int i = from; i < to; i++) {
      char c = text.charAt(i);
      if (c == '&') {
        int end = i + 1;
        while (end < to && text.charAt(end) != ';') {
          end++;
        }
        reference(text.subSequence(i + 1, end).toString(), value, lineEnd, entities);
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

  private static void reference(String name, StringBuilder into, char lineEnd, Entities entities) {
    switch (name) {
      case "lt" -> into.append('<');
      case "gt" -> into.append('>');
      case "amp" -> into.append('&');
      case "quot" -> into.append('"');
      case "apos" -> into.append('\'');
      default -> {
        if (!character(name, into)) {
          Optional<String> known = entities.value(name);
          if (known.isPresent()) {
            // Its own references are replaced but for those to characters.
            into.append(read(known.get(), 0, known.get().length(), lineEnd, Entities.NONE));
          } else {
            into.append('&').append(name).append(';'); // external, or of a scene that is run
          }
        }
      }
    }
  }

  /** Appends the character that a reference such as {@code #x41} means; false if it is none. */
  private static boolean character(String name, StringBuilder into) {
    try {
      if (name.startsWith("#x")) {
        into.appendCodePoint(Integer.parseInt(name.substring(2), 16));
      } else if (name.startsWith("#")) {
        into.appendCodePoint(Integer.parseInt(name.substring(1)));
      } else {
        return false;
      }
      return true;
    } catch (IllegalArgumentException e) {
      return false; // no number, or that of no character
    }
  }
}
