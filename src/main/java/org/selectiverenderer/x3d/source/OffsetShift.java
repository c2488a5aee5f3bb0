package org.selectiverenderer.x3d.source;

import java.util.Arrays;
import java.util.List;

/** Where offsets go when changes are made. */
final class OffsetShift {
  private final int[] from;
  private final int[] to;
  private final int[] growth;

  OffsetShift(List<TextChange> changes) {
    from = changes.stream().mapToInt(TextChange::from).toArray();
    to = changes.stream().mapToInt(TextChange::to).toArray();
    growth = new int[from.length + 1];
    for (int i = 0; i < from.length; i++) {
      growth[i + 1] = growth[i] + changes.get(i).growth();
    }
  }

  /** The offset up to which nothing moves. */
  int first() {
    return from.length == 0 ? Integer.MAX_VALUE : from[0];
  }

  /** The offset from which all moves alike, by {@link #total}. */
  int last() {
    return to.length == 0 ? Integer.MAX_VALUE : to[to.length - 1];
  }

  int total() {
    return growth[growth.length - 1];
  }

  /** Of something that begins here: what is inserted here comes before it. */
  int start(int offset) {
    return offset + growth[upTo(offset)];
  }

  /** Of something that ends here: what is inserted here comes behind it. */
  int end(int offset) {
    int count = upTo(offset);
    while (count > 0 && from[count - 1] == offset) {
      count--;
    }
    return offset + growth[count];
  }

  /** How many changes lie before an offset or end at it. */
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
