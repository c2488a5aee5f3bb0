package org.selectiverenderer.document.hand;

/** Detects the quote character that the author uses around attribute values. */
final class Quotes {
  private static final int FAR = 4096;

  private Quotes() {}

  /**
   * Returns the quote character of the last attribute before an offset; {@code '} if there is none
   * nearby.
   */
  static char near(CharSequence text, int offset) {
    for (int i = offset - 2; i >= Math.max(0, offset - FAR); i--) {
      char next = text.charAt(i + 1);
      if (text.charAt(i) == '=' && (next == '"' || next == '\'')) {
        return next;
      }
    }
    return '\'';
  }
}
