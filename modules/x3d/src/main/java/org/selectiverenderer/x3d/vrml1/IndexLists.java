package org.selectiverenderer.x3d.vrml1;

import java.util.function.IntUnaryOperator;

/** Makes and measures lists of indices, in which -1 ends a face or line. */
final class IndexLists {
  private IndexLists() {}

  /** Returns the number of faces or lines. */
  static int pieces(int[] indices) {
    int count = 0;
    for (int i = 0; i < indices.length; i++) {
      boolean last = i + 1 == indices.length || indices[i + 1] < 0;
      count += indices[i] >= 0 && last ? 1 : 0;
    }
    return count;
  }

  /** Returns the number of indices but -1. */
  static int corners(int[] indices) {
    int count = 0;
    for (int index : indices) {
      count += index >= 0 ? 1 : 0;
    }
    return count;
  }

  /** Returns whether all indices are below a limit. */
  static boolean below(int[] indices, int limit) {
    for (int index : indices) {
      if (index >= limit) {
        return false;
      }
    }
    return true;
  }

  /** Returns the numbers 0, 1, 2 and so on in the place of the indices, mapped. */
  static String sequence(int[] like, IntUnaryOperator mapping) {
    StringBuilder text = new StringBuilder(3 * like.length);
    int next = 0;
    for (int index : like) {
      text.append(text.length() == 0 ? "" : " ");
      text.append(index < 0 ? -1 : mapping.applyAsInt(next++));
    }
    return text.toString();
  }

  /** Returns the numbers from 0 to below a count, mapped. */
  static String count(int count, IntUnaryOperator mapping) {
    return sequence(new int[count], mapping);
  }

  /** Returns each segment of lines as a line of its own. */
  static String segments(int[] lines) {
    StringBuilder text = new StringBuilder(6 * lines.length);
    for (int i = 1; i < lines.length; i++) {
      if (lines[i - 1] >= 0 && lines[i] >= 0) {
        text.append(text.length() == 0 ? "" : " ");
        text.append(lines[i - 1]).append(' ').append(lines[i]).append(" -1");
      }
    }
    return text.toString();
  }

  /** Returns the number of segments of lines. */
  static int segmentCount(int[] lines) {
    int count = 0;
    for (int i = 1; i < lines.length; i++) {
      count += lines[i - 1] >= 0 && lines[i] >= 0 ? 1 : 0;
    }
    return count;
  }
}
