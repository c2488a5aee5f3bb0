package org.selectiverenderer.x3d.source;

import java.util.List;

/**
 * A replacement of a range of characters.
 *
 * @param from the offset of the first replaced character
 * @param to the offset after the last replaced character; equal to {@code from} for an insertion
 * @param text the replacement
 */
public record TextChange(int from, int to, String text) {
  /** Checks the range. */
  public TextChange {
    if (from < 0 || to < from) {
      throw new IllegalArgumentException("from " + from + " to " + to);
    }
  }

  /** Returns an insertion. */
  public static TextChange insert(int at, String text) {
    return new TextChange(at, at, text);
  }

  /** Returns a deletion. */
  public static TextChange remove(int from, int to) {
    return new TextChange(from, to, "");
  }

  /**
   * Applies changes to a text.
   *
   * @param changes the changes, sorted and without overlaps
   */
  public static StringBuilder applied(List<TextChange> changes, CharSequence text) {
    int growth = changes.stream().mapToInt(TextChange::growth).sum();
    StringBuilder changed = new StringBuilder(text.length() + Math.max(0, growth));
    int at = 0;
    for (TextChange change : changes) {
      changed.append(text, at, change.from()).append(change.text());
      at = change.to();
    }
    return changed.append(text, at, text.length());
  }

  /** Returns by how many characters the text grows. */
  public int growth() {
    return text.length() - (to - from);
  }
}
