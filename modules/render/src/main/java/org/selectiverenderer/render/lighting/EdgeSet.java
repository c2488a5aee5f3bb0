package org.selectiverenderer.render.lighting;

import java.util.Arrays;

/** A set of undirected edges between vertex numbers, numbered in sorted order. */
final class EdgeSet {
  private long[] keys = new long[64];
  private int count;

  void add(int a, int b) {
    if (count == keys.length) {
      keys = Arrays.copyOf(keys, 2 * count);
    }
    keys[count++] = key(a, b);
  }

  /** Sorts the set and removes duplicates, after the last edge was added. */
  void close() {
    Arrays.sort(keys, 0, count);
    int kept = 0;
    for (int i = 0; i < count; i++) {
      if (kept == 0 || keys[kept - 1] != keys[i]) {
        keys[kept++] = keys[i];
      }
    }
    count = kept;
  }

  int size() {
    return count;
  }

  /** Returns the number of an edge; below 0 if it is not in the set. */
  int number(int a, int b) {
    return Arrays.binarySearch(keys, 0, count, key(a, b));
  }

  int low(int number) {
    return (int) (keys[number] >>> 32);
  }

  int high(int number) {
    return (int) keys[number];
  }

  private static long key(int a, int b) {
    return (long) Math.min(a, b) << 32 | Math.max(a, b);
  }
}
