package org.selectiverenderer.document;

import java.util.Arrays;

/** Where the lines of a text start; a line ends with LF, CR LF or CR, as XML reads them. */
final class LineIndex {
  private static final int[] UNKNOWN = {};

  private int[] starts;
  private int count;

  LineIndex(CharSequence text) {
    this.starts = UNKNOWN;
    build(text);
  }

  /** Forgets all; the next question finds the lines again. */
  void reset() {
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
    for (int i = Math.max(1, from); i <= to && i <= text.length(); i++) {
      char before = text.charAt(i - 1);
      boolean middle = before == '\r' && i < text.length() && text.charAt(i) == '\n';
      if (before == '\n' || before == '\r' && !middle) {
        add(i);
      }
    }
  }

  private void add(int start) {
    if (count == starts.length) {
      starts = Arrays.copyOf(starts, Math.max(16, 2 * count));
    }
    starts[count++] = start;
  }

  /** One change has been made; the text is as it is after it. */
  void changed(TextChange change, CharSequence text) {
    if (count == 0) {
      return;
    }
    int before = atMost(change.from() - 1);
    int behind = atMost(change.to());
    int[] kept = Arrays.copyOfRange(starts, behind, count);
    count = before;
    if (change.from() == 0) {
      add(0);
    }
    scan(text, change.from(), change.from() + change.text().length());
    int room = count + kept.length;
    if (room > starts.length) {
      starts = Arrays.copyOf(starts, room + room / 8);
    }
    int growth = change.growth();
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
  int line(CharSequence text, int offset) {
    know(text);
    return atMost(offset);
  }

  /** The offset at which a line starts; lines beyond the last are the last. */
  int start(CharSequence text, int line) {
    know(text);
    return starts[Math.max(0, Math.min(line, count) - 1)];
  }
}
