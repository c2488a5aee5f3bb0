package org.selectiverenderer.x3d.source;

import java.util.List;

/**
 * A replacement of characters.
 *
 * @param from offset of the first character that goes
 * @param to offset behind the last one that goes; equal to {@code from} for an insertion
 * @param text what comes in their place
 */
public record TextChange(int from, int to, String text) {
  /** Refuses an end before the beginning. */
  public TextChange {
    if (from < 0 || to < from) {
      throw new IllegalArgumentException("from " + from + " to " + to);
    }
  }

  /** Puts text at a place. */
  public static TextChange insert(int at, String text) {
    return new TextChange(at, at, text);
  }

  /** Takes text away. */
  public static TextChange remove(int from, int to) {
    return new TextChange(from, to, "");
  }

  /**
   * A text with changes.
   *
   * @param changes sorted, without overlaps
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

  /** By how many characters the text grows. */
  public int growth() {
    return text.length() - (to - from);
  }
}
