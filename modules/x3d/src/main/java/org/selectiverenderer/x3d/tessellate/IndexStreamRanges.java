package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;

/**
 * The ranges of a node's index stream that form its faces, strips, fans or polylines: range {@code
 * r} has the stream positions {@code bounds[2r]} up to but not including {@code bounds[2r + 1]}.
 */
record IndexStreamRanges(int[] bounds, int count) {

  int from(int run) {
    return bounds[2 * run];
  }

  int to(int run) {
    return bounds[2 * run + 1];
  }

  /** Splits a stream into ranges that end with -1, which is optional after the last one. */
  static IndexStreamRanges separated(int[] stream) {
    int[] bounds = new int[Math.max(8, stream.length / 2)];
    int count = 0;
    int from = 0;
    for (int i = 0; i <= stream.length; i++) {
      boolean end = i == stream.length;
      if (end ? i > from : stream[i] == -1) {
        if (2 * count + 2 > bounds.length) {
          bounds = Arrays.copyOf(bounds, bounds.length * 2);
        }
        bounds[2 * count] = from;
        bounds[2 * count + 1] = i;
        count++;
        from = i + 1;
      }
    }
    return new IndexStreamRanges(bounds, count);
  }

  /**
   * Returns consecutive ranges of given lengths.
   *
   * @param field the field with the lengths; ranges beyond {@code available} points are left out
   *     and reported
   * @param least the least valid length; shorter ranges draw nothing and are reported
   */
  static IndexStreamRanges counted(
      TessellationContext job, String field, int least, int available) {
    int[] lengths = job.node().ints(field);
    int[] bounds = new int[2 * lengths.length];
    int from = 0;
    int tooShort = 0;
    for (int run = 0; run < lengths.length; run++) {
      int length = Math.max(0, lengths[run]);
      if (length > available - from) {
        job.problem(
            "has a " + field + " that asks for more points than there are; the rest is left out");
        return new IndexStreamRanges(bounds, run);
      }
      tooShort += lengths[run] < least ? 1 : 0;
      bounds[2 * run] = from;
      bounds[2 * run + 1] = from + length;
      from += length;
    }
    if (tooShort > 0) {
      job.problem("has a value below " + least + " in " + field + "; nothing is drawn for it");
    }
    return new IndexStreamRanges(bounds, lengths.length);
  }

  /** Returns the stream of a node without an index: 0, 1, 2 ... */
  static int[] identity(int length) {
    int[] stream = new int[length];
    for (int i = 0; i < length; i++) {
      stream[i] = i;
    }
    return stream;
  }
}
