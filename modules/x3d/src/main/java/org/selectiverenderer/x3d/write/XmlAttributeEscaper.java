package org.selectiverenderer.x3d.write;

/** Escapes attribute values for XML (XML 1.0, 2.4 and 3.3.3). */
public final class XmlAttributeEscaper {
  private XmlAttributeEscaper() {}

  /**
   * Escapes a value for quotes of one kind, so that any XML parser reads the same value; line ends
   * and tabs are written as references.
   *
   * @param quote {@code '} or {@code "}
   */
  public static String escaped(CharSequence value, char quote) {
    StringBuilder text = new StringBuilder(value.length() + 8);
    append(text, value, quote);
    return text.toString();
  }

  static void append(StringBuilder text, CharSequence value, char quote) {
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      switch (c) {
        case '&' -> text.append("&amp;");
        case '<' -> text.append("&lt;");
        case '"' -> text.append(quote == '"' ? "&quot;" : "\"");
        case '\'' -> text.append(quote == '\'' ? "&apos;" : "'");
        case '\n', '\r', '\t' -> text.append("&#").append((int) c).append(';');
        default -> text.append(c);
      }
    }
  }
}
