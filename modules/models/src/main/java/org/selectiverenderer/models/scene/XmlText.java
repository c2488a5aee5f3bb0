package org.selectiverenderer.models.scene;

/** Text of models as text of XML. */
public final class XmlText {
  private XmlText() {}

  /** Returns a text with U+FFFD in the place of characters that XML forbids (XML 1.0, 2.2). */
  public static String of(String given) {
    StringBuilder text = new StringBuilder();
    given.codePoints().map(c -> isXml(c) ? c : 0xfffd).forEach(text::appendCodePoint);
    return text.toString();
  }

  private static boolean isXml(int c) {
    return c >= 0x20 && c < 0xd800
        || c > 0xdfff && c < 0xfffe
        || c > 0xffff
        || c == '\t'
        || c == '\n'
        || c == '\r';
  }
}
