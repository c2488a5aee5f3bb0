package org.selectiverenderer.geometry.mesh;

/**
 * Packs a directed edge, two vertex indices, into a {@code long} key for hash tables. The packed
 * indices are multiplied by an odd constant (Fibonacci hashing), since {@link Long#hashCode} is the
 * exclusive or of the two halves, which for the nearby indices of an edge takes only few values.
 */
public final class EdgeKey {
  /** An odd multiplier that mixes the bits; {@link #GATHER} is its inverse modulo 2^64. */
  private static final long SPREAD = 0x9E3779B97F4A7C15L;

  private static final long GATHER = 0xF1DE83E19937733DL;

  private EdgeKey() {}

  /** Returns the key of a directed edge; the opposite direction has another key. */
  public static long of(int from, int to) {
    return ((long) from << 32 | to & 0xffffffffL) * SPREAD;
  }

  /** Returns the start vertex of a key's edge. */
  public static int from(long key) {
    return (int) (key * GATHER >>> 32);
  }

  /** Returns the end vertex of a key's edge. */
  public static int to(long key) {
    return (int) (key * GATHER);
  }
}
