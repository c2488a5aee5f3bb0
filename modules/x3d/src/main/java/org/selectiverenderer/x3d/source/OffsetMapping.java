package org.selectiverenderer.x3d.source;

import java.util.Arrays;
import java.util.List;

/** Maps offsets in a text before changes to those after the changes. */
final class OffsetMapping {
  private final int[] from;
  private final int[] to;
  private final int[] growth;

  OffsetMapping(List<TextEdit> changes) {
    from = changes.stream().mapToInt(TextEdit::from).toArray();
    to = changes.stream().mapToInt(TextEdit::to).toArray();
    growth = new int[from.length + 1];
    for (int i = 0; i < from.length; i++) {
      growth[i + 1] = growth[i] + changes.get(i).growth();
    }
  }

  /** Returns the offset of the first change, before which nothing moves. */
  int first() {
    return from.length == 0 ? Integer.MAX_VALUE : from[0];
  }

  /** Returns the end of the last change, from which on all offsets move by {@link #total}. */
  int last() {
    return to.length == 0 ? Integer.MAX_VALUE : to[to.length - 1];
  }

  int total() {
    return growth[growth.length - 1];
  }

  /** Maps the start of a range; text inserted at the offset precedes the range. */
  int start(int offset) {
    return offset + growth[upTo(offset)];
  }

  /** Maps the end of a range; text inserted at the offset follows the range. */
  int end(int offset) {
    int count = upTo(offset);
    while (count > 0 && from[count - 1] == offset) {
      count--;
    }
    return offset + growth[count];
  }

  /** Returns the number of changes that end at or before an offset. */
  private int upTo(int offset) {
    int found = Arrays.binarySearch(to, offset);
    if (found < 0) {
      return -found - 1;
    }
    while (found < to.length && to[found] == offset) {
      found++;
    }
    return found;
  }
}
