package org.selectiverenderer.x3d.source;

import java.util.Optional;

/** Normalizes attribute values: resolves references and white space (XML 1.0, 3.3.3). */
final class AttributeValueNormalizer {
  private AttributeValueNormalizer() {}

  /** Returns the normalized attribute value of a part of a text (XML 1.0, 3.3.3). */
  static String read(CharSequence text, int from, int to) {
    return read(text, from, to, ' ', EntityTable.NONE);
  }

  /**
   * Returns the normalized value with another replacement of line ends.
   *
   * @param lineEnd a blank, as in XML, or {@code \n}
   * @param entities the entities for further references
   */
  static String read(CharSequence text, int from, int to, char lineEnd, EntityTable entities) {
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

  private static void reference(
      String name, StringBuilder into, char lineEnd, EntityTable entities) {
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
            // nested entities are already expanded, but not character references
            into.append(read(known.get(), 0, known.get().length(), lineEnd, EntityTable.NONE));
          } else {
            into.append('&').append(name).append(';'); // external, or of a running scene
          }
        }
      }
    }
  }

  /** Appends the character of a reference such as {@code #x41}; false if it is invalid. */
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
      return false; // not a number, or not a valid code point
    }
  }
}
