package org.selectiverenderer.x3d.field;

import java.util.ArrayList;
import java.util.List;

/** Reads the quoted strings of an MFString, with the escapes {@code \"} and {@code \\}. */
final class StringScanner {
  private static final String[] NONE = {};

  private StringScanner() {}

  static String[] strings(String text, FieldParseErrors flaws) {
    int at = skip(text, 0);
    if (at == text.length()) {
      return NONE;
    }
    if (text.charAt(at) != '"') {
      flaws.warning(
          at,
          "each string of this field must be in double quotes; the whole value is used "
              + "as one string");
      return new String[] {text.strip()};
    }
    List<String> strings = new ArrayList<>();
    StringBuilder string = new StringBuilder();
    while (at < text.length()) {
      if (text.charAt(at) == '"') {
        string.setLength(0);
        int end = quoted(text, at + 1, string);
        if (end < 0) {
          flaws.error(at, "the closing quote is missing; the string ends at the end of the value");
          end = text.length();
        }
        strings.add(string.toString());
        at = end;
      } else {
        int end = at;
        while (end < text.length()
            && text.charAt(end) != '"'
            && !FieldTokenizer.separates(text.charAt(end))) {
          end++;
        }
        String word = text.substring(at, end);
        flaws.warning(
            at, FieldTokenizer.quote(word) + " is outside of quotes; it is used as a string");
        strings.add(word);
        at = end;
      }
      at = skip(text, at);
    }
    return strings.toArray(NONE);
  }

  /** Reads up to the closing quote and returns the offset after it, or -1 if there is none. */
  private static int quoted(String text, int at, StringBuilder into) {
    while (at < text.length()) {
      char c = text.charAt(at++);
      if (c == '"') {
        return at;
      }
      if (c == '\\' && at < text.length() && (text.charAt(at) == '"' || text.charAt(at) == '\\')) {
        c = text.charAt(at++);
      }
      into.append(c);
    }
    return -1;
  }

  private static int skip(String text, int at) {
    while (at < text.length() && FieldTokenizer.separates(text.charAt(at))) {
      at++;
    }
    return at;
  }
}
