package org.selectiverenderer.enricher.source;

/**
 * The range of the document's text that the source view shows: all of it, or a page of a text that
 * is too large for a text component, which lays out whole lines.
 *
 * @param from offset of its first character
 * @param to offset after its last character
 * @param withinLine whether it begins within a line
 */
record VisibleSourceRange(int from, int to, boolean withinLine) {
  /** Most characters of a text that is shown as a whole. */
  static final int WHOLE = 1_500_000;

  /** Characters per page of a longer text. */
  static final int PAGE = 120_000;

  /** Returns the page around an offset. */
  static VisibleSourceRange around(CharSequence text, int offset) {
    if (text.length() <= WHOLE) {
      return new VisibleSourceRange(0, text.length(), false);
    }
    int at = Math.max(0, Math.min(offset, text.length()));
    int from = lineStart(text, Math.max(0, at - PAGE / 4), at);
    int to = Math.min(text.length(), from + PAGE);
    return new VisibleSourceRange(from, to, from > 0 && text.charAt(from - 1) != '\n');
  }

  /** Returns the first line start from an offset on, before another one; else the offset itself. */
  private static int lineStart(CharSequence text, int from, int before) {
    if (from == 0) {
      return 0;
    }
    for (int i = from; i < before; i++) {
      if (text.charAt(i) == '\n') {
        return i + 1;
      }
    }
    return from;
  }

  boolean holds(int offset) {
    return from <= offset && offset <= to;
  }

  int length() {
    return to - from;
  }
}
