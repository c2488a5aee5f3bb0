package org.selectiverenderer.base.markup;

/**
 * Escapes text for XML and HTML. Characters that XML 1.0 does not allow (section 2.2: control
 * characters except tab and line ends, unpaired surrogates) become question marks; other characters
 * that command what shows them ({@link ControlCharacterEscaper}) become references.
 */
public final class MarkupEscaper {
  private MarkupEscaper() {}

  /** Escapes text for element content. */
  public static String text(String text) {
    return escaped(text, false);
  }

  /** Escapes text for an attribute value in double quotes, or for element content. */
  public static String attribute(String text) {
    return escaped(text, true);
  }

  private static String escaped(String text, boolean quotes) {
    StringBuilder escaped = new StringBuilder(text.length() + 16);
    text.codePoints()
        .forEach(
            c -> {
              switch (c) {
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '&' -> escaped.append("&amp;");
                case '"' -> escaped.append(quotes ? "&quot;" : "\"");
                case '\t', '\n', '\r' -> escaped.append((char) c);
                default -> {
                  if (!known(c)) {
                    escaped.append('?');
                  } else if (ControlCharacterEscaper.isControl(c)) {
                    escaped.append("&#x").append(Integer.toHexString(c)).append(';');
                  } else {
                    escaped.appendCodePoint(c);
                  }
                }
              }
            });
    return escaped.toString();
  }

  private static boolean known(int c) {
    return c >= ' ' && c < 0xd800 || c >= 0xe000 && c != 0xfffe && c != 0xffff;
  }
}
