package org.selectiverenderer.x3d.source;

import java.util.Arrays;

/** An index of the offsets at which the lines of a text start; line ends are LF, CRLF or CR. */
public final class LineIndex {
  private static final int[] UNKNOWN = {};

  private int[] starts;
  private int count;

  /** Creates the index of a text. */
  public LineIndex(CharSequence text) {
    this.starts = UNKNOWN;
    build(text);
  }

  /** Clears the index, which is rebuilt by the next query. */
  public void reset() {
    starts = UNKNOWN;
    count = 0;
  }

  private void build(CharSequence text) {
    starts = new int[Math.max(16, text.length() / 40)];
    count = 0;
    add(0);
    scan(text, 1, text.length());
  }

  /** Adds the line starts of a range, both ends included, after all known ones. */
  private void scan(CharSequence text, int from, int to) {
    int last = Math.min(to, text.length());
    int end = lineEnd(text, Math.max(1, from) - 1, last);
    while (end < last) {
      int next = end + 1;
      boolean middle =
          text.charAt(end) == '\r' && next < text.length() && text.charAt(next) == '\n';
      if (!middle) {
        add(next);
      }
      end = lineEnd(text, next, last);
    }
  }

  /** Returns the offset of the first LF or CR in a range, or its end if there is none. */
  private static int lineEnd(CharSequence text, int from, int to) {
    if (text instanceof SourceText source) {
      return source.lineEnd(from, to);
    }
    int at = from;
    while (at < to && text.charAt(at) != '\n' && text.charAt(at) != '\r') {
      at++;
    }
    return at;
  }

  private void add(int start) {
    if (count == starts.length) {
      starts = Arrays.copyOf(starts, Math.max(16, 2 * count));
    }
    starts[count++] = start;
  }

  /**
   * Updates the index after a replacement of characters.
   *
   * @param from the offset of the first replaced character
   * @param to the offset after the last replaced character
   * @param length the length of the replacement
   * @param text the text after the replacement
   */
  public void changed(int from, int to, int length, CharSequence text) {
    if (count == 0) {
      return;
    }
    int before = atMost(from - 1);
    int behind = atMost(to);
    int[] kept = Arrays.copyOfRange(starts, behind, count);
    count = before;
    if (from == 0) {
      add(0);
    }
    scan(text, from, from + length);
    int room = count + kept.length;
    if (room > starts.length) {
      starts = Arrays.copyOf(starts, room + room / 8);
    }
    int growth = length - (to - from);
    for (int start : kept) {
      starts[count++] = start + growth;
    }
  }

  /** Returns the number of lines that start at or before an offset. */
  private int atMost(int offset) {
    int found = Arrays.binarySearch(starts, 0, count, offset);
    return found >= 0 ? found + 1 : -found - 1;
  }

  private void know(CharSequence text) {
    if (count == 0) {
      build(text);
    }
  }

  /** Returns the line of a character, from 1. */
  public int line(CharSequence text, int offset) {
    know(text);
    return atMost(offset);
  }

  /** Returns the offset at which a line, or else the last line, starts. */
  public int start(CharSequence text, int line) {
    know(text);
    return starts[Math.max(0, Math.min(line, count) - 1)];
  }
}
