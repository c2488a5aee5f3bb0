package org.selectiverenderer.x3d.source;

import java.util.Arrays;

/** Where the lines of a text start; a line ends with LF, CR LF or CR, as XML reads them. */
public final class LineIndex {
  private static final int[] UNKNOWN = {};

  private int[] starts;
  private int count;

  /** The lines of a text. */
  public LineIndex(CharSequence text) {
    this.starts = UNKNOWN;
    build(text);
  }

  /** Forgets all; the next question finds the lines again. */
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

  /** Adds the starts from an offset to another, both included; they must be behind all known. */
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

  /** The offset of the first LF or CR; the second offset if there is none in between. */
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
   * Characters have been replaced.
   *
   * @param from offset of the first that went
   * @param to offset behind the last that went
   * @param length of what came in their place
   * @param text as it is now
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

  /** How many lines start at or before an offset. */
  private int atMost(int offset) {
    int found = Arrays.binarySearch(starts, 0, count, offset);
    return found >= 0 ? found + 1 : -found - 1;
  }

  private void know(CharSequence text) {
    if (count == 0) {
      build(text);
    }
  }

  /** The line of a character, from 1. */
  public int line(CharSequence text, int offset) {
    know(text);
    return atMost(offset);
  }

  /** The offset at which a line starts; lines beyond the last are the last. */
  public int start(CharSequence text, int line) {
    know(text);
    return starts[Math.max(0, Math.min(line, count) - 1)];
  }
}
