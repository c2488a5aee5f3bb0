package org.selectiverenderer.geometry.mesh;

/**
 * Edges as keys of hash tables. Two numbers side by side in a long would meet in few places of such
 * a table: {@link Long#hashCode} is the one exclusive-or the other, which is small for numbers that
 * are near each other, as those of an edge's ends are.
 */
public final class EdgeKey {
  /** An odd number spreads all that it multiplies over all bits; another takes that back. */
  private static final long SPREAD = 0x9E3779B97F4A7C15L;

  private static final long GATHER = 0xF1DE83E19937733DL;

  private EdgeKey() {}

  /** The key of the edge from a point to another; other than that of the way back. */
  public static long of(int from, int to) {
    return ((long) from << 32 | to & 0xffffffffL) * SPREAD;
  }

  /** The point from which a key's edge leads. */
  public static int from(long key) {
    return (int) (key * GATHER >>> 32);
  }

  /** The point to which a key's edge leads. */
  public static int to(long key) {
    return (int) (key * GATHER);
  }
}
