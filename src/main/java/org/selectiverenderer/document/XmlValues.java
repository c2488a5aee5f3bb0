package org.selectiverenderer.document;

import java.util.List;
import java.util.stream.Collectors;
import org.selectiverenderer.x3d.FieldParser;
import org.selectiverenderer.x3d.FieldType;

/** Values of attributes as they are written, and as they are meant. */
public final class XmlValues {
  private XmlValues() {}

  /** What a part of a text means as an attribute's value (XML 1.0, 3.3.3). */
  static String read(CharSequence text, int from, int to) {
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
        value.append(' ');
        i++;
      } else {
        value.append(c < ' ' ? ' ' : c);
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

  /** A value as it is written between quotes of that kind. */
  public static String written(String value, char quote) {
    StringBuilder written = new StringBuilder(value.length() + 8);
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      switch (c) {
        case '&' -> written.append("&amp;");
        case '<' -> written.append("&lt;");
        case '"' -> written.append(quote == '"' ? "&quot;" : "\"");
        case '\'' -> written.append(quote == '\'' ? "&apos;" : "'");
        case '\n', '\r', '\t' -> written.append("&#").append((int) c).append(';');
        default -> written.append(c);
      }
    }
    return written.toString();
  }

  /** The strings of an MFString, tolerant as the reader of scenes is. */
  public static List<String> strings(String value) {
    int last = value.length() - 1;
    boolean one =
        last > 0
            && value.charAt(0) == '"'
            && value.indexOf('"', 1) == last
            && !value.contains("\\");
    if (one) {
      return List.of(value.substring(1, last)); // nearly all are: no parser is needed
    }
    Object parsed = new FieldParser().parse(FieldType.MFString, value).value();
    return parsed == null ? List.of() : List.of((String[]) parsed);
  }

  /** Strings as an MFString. */
  public static String multiple(List<String> strings) {
    return strings.stream()
        .map(string -> '"' + string.replace("\\", "\\\\").replace("\"", "\\\"") + '"')
        .collect(Collectors.joining(" "));
  }
}
