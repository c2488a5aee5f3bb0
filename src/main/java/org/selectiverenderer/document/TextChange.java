package org.selectiverenderer.document;

/**
 * A replacement of characters.
 *
 * @param from offset of the first character that goes
 * @param to offset behind the last one that goes; equal to {@code from} for an insertion
 * @param text what comes in their place
 */
public record TextChange(int from, int to, String text) {
  public TextChange {
    if (from < 0 || to < from) {
      throw new IllegalArgumentException("from " + from + " to " + to);
    }
  }

  public static TextChange insert(int at, String text) {
    return new TextChange(at, at, text);
  }

  public static TextChange remove(int from, int to) {
    return new TextChange(from, to, "");
  }

  /** By how many characters the text grows. */
  int growth() {
    return text.length() - (to - from);
  }
}
