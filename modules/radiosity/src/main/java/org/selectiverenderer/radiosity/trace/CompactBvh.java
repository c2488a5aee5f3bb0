package org.selectiverenderer.radiosity.trace;

import org.selectiverenderer.geometry.bvh.Bvh;

/**
 * A bounding volume hierarchy in a compact layout for traversal: the boxes of two siblings and
 * their links lie side by side, so that a step touches one or two cache lines instead of four.
 *
 * @param nodes {@link #STRIDE} numbers per pair: min x, y, z, max x, y, z of the left box, those of
 *     the right one, then, as the bits of an int, the links of the left and the right one
 * @param root the first link. A link is the index of a pair's first number, or a {@link #LEAF}
 */
record CompactBvh(float[] nodes, int root) {
  /** Numbers of a pair; a cache line has room for as many floats. */
  static final int STRIDE = 16;

  /** Offset of the numbers of the right box. */
  static final int RIGHT = 6;

  /** Offset of the left link; the right link follows. */
  static final int LINK = 12;

  /** The bit set in links to leaves, which are negative. No link has the bits of a NaN. */
  static final int LEAF = 1 << 31;

  private static final int COUNT_BITS = 3;

  /** Packs a tree whose leaves have seven items at most. */
  static CompactBvh of(Bvh tree) {
    int[] first = tree.first();
    int[] count = tree.count();
    if (tree.order().length == 0) {
      return new CompactBvh(new float[0], LEAF);
    }
    // The children of all inner nodes lie in pairs after the root.
    float[] nodes = new float[Math.multiplyExact(STRIDE, (count.length - 1) / 2)];
    for (int node = 0; node < count.length; node++) {
      if (count[node] == 0) {
        int left = first[node];
        int at = pair(left);
        System.arraycopy(tree.boxes(), 6 * left, nodes, at, 12);
        nodes[at + LINK] = Float.intBitsToFloat(link(left, first, count));
        nodes[at + LINK + 1] = Float.intBitsToFloat(link(left + 1, first, count));
      }
    }
    return new CompactBvh(nodes, link(0, first, count));
  }

  private static int pair(int left) {
    return STRIDE * ((left - 1) / 2);
  }

  private static int link(int node, int[] first, int[] count) {
    return count[node] > 0 ? LEAF | first[node] << COUNT_BITS | count[node] : pair(first[node]);
  }

  /** Returns the first item of a leaf. */
  static int first(int leaf) {
    return (leaf & ~LEAF) >> COUNT_BITS;
  }

  /** Returns the index at which the items of a leaf end. */
  static int end(int leaf) {
    return first(leaf) + (leaf & (1 << COUNT_BITS) - 1);
  }
}
