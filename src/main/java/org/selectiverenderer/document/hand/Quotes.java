package org.selectiverenderer.document.hand;

/** The quotation mark that an author puts around values. */
final class Quotes {
  private static final int FAR = 4096;

  private Quotes() {}

  /** The one of the last attribute before an offset; {@code '} where there is none near. */
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
