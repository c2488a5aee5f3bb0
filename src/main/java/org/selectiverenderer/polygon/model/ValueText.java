package org.selectiverenderer.polygon.model;

import org.selectiverenderer.x3d.FieldType;

/** Field values as X3D text (ISO/IEC 19776-1, 5). */
public final class ValueText {
  private ValueText() {}

  /**
   * @param value as {@link FieldType} represents it; no node
   */
  public static String of(FieldType type, Object value) {
    StringBuilder text = new StringBuilder();
    if (value instanceof float[] numbers) {
      for (float number : numbers) {
        separate(text).append(NumberText.shortest(number));
      }
    } else if (value instanceof double[] numbers) {
      for (double number : numbers) {
        separate(text).append(NumberText.shortest(number));
      }
    } else if (value instanceof int[] numbers) {
      for (int number : numbers) {
        separate(text).append(number);
      }
    } else if (value instanceof boolean[] flags) {
      for (boolean flag : flags) {
        separate(text).append(flag);
      }
    } else if (value instanceof String[] strings) {
      for (String string : strings) {
        separate(text).append('"');
        text.append(string.replace("\\", "\\\\").replace("\"", "\\\"")).append('"');
      }
    } else if (value instanceof Float number) {
      text.append(NumberText.shortest(number));
    } else if (value instanceof Double number) {
      text.append(NumberText.shortest(number));
    } else {
      text.append(value);
    }
    return text.toString();
  }

  private static StringBuilder separate(StringBuilder text) {
    return text.length() == 0 ? text : text.append(' ');
  }

  /** Text for an attribute in single quotes. */
  public static String escape(String text) {
    StringBuilder escaped = new StringBuilder(text.length() + 16);
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '&' -> escaped.append("&amp;");
        case '<' -> escaped.append("&lt;");
        case '\'' -> escaped.append("&apos;");
        case '\n' -> escaped.append("&#10;");
        case '\r' -> escaped.append("&#13;");
        case '\t' -> escaped.append("&#9;");
        default -> escaped.append(c);
      }
    }
    return escaped.toString();
  }
}
