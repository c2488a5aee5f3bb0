package org.selectiverenderer.x3d.source;

import java.util.List;

/**
 * A replacement of a range of characters.
 *
 * @param from the offset of the first replaced character
 * @param to the offset after the last replaced character; equal to {@code from} for an insertion
 * @param text the replacement
 */
public record TextEdit(int from, int to, String text) {
  /** Checks the range. */
  public TextEdit {
    if (from < 0 || to < from) {
      throw new IllegalArgumentException("from " + from + " to " + to);
    }
  }

  /** Returns an insertion. */
  public static TextEdit insert(int at, String text) {
    return new TextEdit(at, at, text);
  }

  /** Returns a deletion. */
  public static TextEdit remove(int from, int to) {
    return new TextEdit(from, to, "");
  }

  /**
   * Applies changes to a text.
   *
   * @param changes the changes, sorted and without overlaps
   */
  public static StringBuilder applied(List<TextEdit> changes, CharSequence text) {
    int growth = changes.stream().mapToInt(TextEdit::growth).sum();
    StringBuilder changed = new StringBuilder(text.length() + Math.max(0, growth));
    int at = 0;
    for (TextEdit change : changes) {
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
