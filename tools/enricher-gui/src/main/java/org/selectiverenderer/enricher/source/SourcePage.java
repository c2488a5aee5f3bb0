package org.selectiverenderer.enricher.source;

/**
 * The part of a text that the source view holds: all of it, or a page of one that is too big for a
 * text component, whose lines are laid out as wholes.
 *
 * @param from offset of its first character
 * @param to offset behind its last one
 * @param plain whether it is shown without highlighting
 */
record SourcePage(int from, int to, boolean plain) {
  /** Characters that are shown as a whole. */
  static final int WHOLE = 1_500_000;

  /** Characters of a page of a longer text. */
  static final int PAGE = 120_000;

  /** Longer lines make a view slow. */
  static final int LONG_LINE = 20_000;

  /** The page around an offset. */
  static SourcePage around(CharSequence text, int offset) {
    if (text.length() <= WHOLE && longestLine(text, 0, text.length()) <= LONG_LINE) {
      return new SourcePage(0, text.length(), false);
    }
    int at = Math.max(0, Math.min(offset, text.length()));
    int from = lineStart(text, Math.max(0, at - PAGE / 4), at);
    int to = Math.min(text.length(), from + PAGE);
    return new SourcePage(from, to, longestLine(text, from, to) > LONG_LINE);
  }

  /** The first start of a line from an offset on; the offset itself if there is none before. */
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

  private static int longestLine(CharSequence text, int from, int to) {
    int longest = 0;
    int start = from;
    for (int i = from; i < to; i++) {
      char c = text.charAt(i);
      if (c == '\n' || c == '\r') {
        longest = Math.max(longest, i - start);
        start = i + 1;
      }
    }
    return Math.max(longest, to - start);
  }

  boolean holds(int offset) {
    return from <= offset && offset <= to;
  }

  int length() {
    return to - from;
  }
}
