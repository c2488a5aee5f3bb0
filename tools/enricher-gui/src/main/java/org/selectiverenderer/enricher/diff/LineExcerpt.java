package org.selectiverenderer.enricher.diff;

/**
 * The part of a line around its difference from another line, as far as it has room.
 *
 * @param text with an ellipsis at each end that is cut
 * @param from offset in the text of the first character that differs
 * @param to offset after the last one
 * @param cut whether the line has more text
 */
record LineExcerpt(String text, int from, int to, boolean cut) {
  private static final String ELLIPSIS = "\u2026";

  /** Returns a line or what has room of it; the difference begins after a third of the room. */
  static LineExcerpt of(String line, String other, int room) {
    int prefix = prefix(line, other);
    int end = line.length() - suffix(line, other, prefix);
    int width = Math.max(3, room);
    if (line.length() <= width) {
      return new LineExcerpt(line, prefix, end, false);
    }
    int wanted = end <= width - 1 ? 0 : Math.min(prefix - width / 3, line.length() - width + 1);
    int start = start(line, Math.max(0, wanted));
    String before = start > 0 ? ELLIPSIS : "";
    int stop = line.length();
    if (stop - start > width - before.length()) {
      stop = start(line, start + width - before.length() - 1);
    }
    int shift = before.length() - start;
    return new LineExcerpt(
        before + line.substring(start, stop) + (stop < line.length() ? ELLIPSIS : ""),
        Math.min(prefix, stop) + shift,
        Math.min(end, stop) + shift,
        true);
  }

  /** Returns the number of characters with which both begin. */
  private static int prefix(String line, String other) {
    int most = Math.min(line.length(), other.length());
    int same = 0;
    while (same < most && line.charAt(same) == other.charAt(same)) {
      same++;
    }
    return start(line, same);
  }

  private static int suffix(String line, String other, int prefix) {
    int most = Math.min(line.length(), other.length()) - prefix;
    int same = 0;
    while (same < most
        && line.charAt(line.length() - 1 - same) == other.charAt(other.length() - 1 - same)) {
      same++;
    }
    boolean within = same > 0 && Character.isLowSurrogate(line.charAt(line.length() - same));
    return within ? same - 1 : same;
  }

  /** Returns an offset, or the one before if it is within a pair of surrogates. */
  private static int start(String line, int at) {
    boolean within = at > 0 && at < line.length() && Character.isLowSurrogate(line.charAt(at));
    return within && Character.isHighSurrogate(line.charAt(at - 1)) ? at - 1 : at;
  }
}
