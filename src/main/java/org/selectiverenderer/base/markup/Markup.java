package org.selectiverenderer.base.markup;

/**
 * Text as XML and HTML write it. What XML 1.0 cannot hold at all (section 2.2: control characters
 * but tab and line ends, halves of surrogate pairs) becomes a question mark.
 */
public final class Markup {
  private Markup() {}

  /** As content of an element. */
  public static String text(String text) {
    return escaped(text, false);
  }

  /** As the value of an attribute in double quotes; also content of an element. */
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
                default -> escaped.appendCodePoint(known(c) ? c : '?');
              }
            });
    return escaped.toString();
  }

  private static boolean known(int c) {
    return c >= ' ' && c < 0xd800
        || c >= 0xe000 && c != 0xfffe && c != 0xffff
        || c == '\t'
        || c == '\n'
        || c == '\r';
  }
}
