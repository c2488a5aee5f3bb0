package org.selectiverenderer.x3d.source;

import java.util.Arrays;

/**
 * Maps offsets of a text whose entities are expanded to offsets of the original text: a character
 * of an expansion is located at its reference.
 */
final class ExpansionMapping {
  private int[] starts = new int[16];
  private int[] ends = new int[16];
  private int[] references = new int[16];
  private int[] behind = new int[16];
  private int count;

  /**
   * Adds an expansion after all others.
   *
   * @param start the offset at which the expansion begins
   * @param reference the offset of its reference in the original text
   */
  void begin(int start, int reference) {
    if (count == starts.length) {
      starts = Arrays.copyOf(starts, 2 * count);
      ends = Arrays.copyOf(ends, 2 * count);
      references = Arrays.copyOf(references, 2 * count);
      behind = Arrays.copyOf(behind, 2 * count);
    }
    starts[count] = start;
    ends[count] = Integer.MAX_VALUE;
    references[count] = reference;
    behind[count] = reference;
    count++;
  }

  /**
   * Ends the last expansion.
   *
   * @param end the offset after the expansion
   * @param original the offset after its reference in the original text
   */
  void end(int end, int original) {
    ends[count - 1] = end;
    behind[count - 1] = original;
  }

  /** Returns the offset in the original text. */
  int original(int offset) {
    int low = 0;
    int high = count;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (starts[middle] <= offset) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    if (low == 0) {
      return offset;
    }
    // an expansion that ends where an empty one begins counts as ended
    int last = low - 1;
    return offset < ends[last] ? references[last] : behind[last] + (offset - ends[last]);
  }
}
