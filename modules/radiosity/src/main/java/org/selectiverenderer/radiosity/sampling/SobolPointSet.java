package org.selectiverenderer.radiosity.sampling;

/**
 * A low-discrepancy point set in the unit square: Sobol's sequence in pairs of dimensions, each
 * pair shuffled and scrambled by an integer hash (Kollig and Keller 2002; Burley 2020, "Practical
 * Hash-based Owen Scrambling"). Any run of consecutive points is well distributed too, so that
 * several sample points can share one set.
 */
public final class SobolPointSet {
  private static final float SCALE = 0x1p-24f;

  private final int size;
  private final float[] x;
  private final float[] y;

  /**
   * @param size number of points
   * @param seed random seed of the set
   * @param pair number of the pair of dimensions; different pairs are independent
   */
  public SobolPointSet(int size, int seed, int pair) {
    this.size = size;
    x = new float[size];
    y = new float[size];
    int base = hash(seed * 0x9e3779b9 + pair);
    for (int i = 0; i < size; i++) {
      int index = scramble(i, hash(base + 1));
      x[i] = unit(Integer.reverse(index) ^ hash(base + 2));
      y[i] = unit(second(index) ^ hash(base + 3));
    }
  }

  public int size() {
    return size;
  }

  /** In 0 .. 1, 1 excluded. */
  public float x(int i) {
    return x[i];
  }

  /** In 0 .. 1, 1 excluded. */
  public float y(int i) {
    return y[i];
  }

  /**
   * Adds two numbers of 0 .. 1 modulo 1 (Cranley-Patterson rotation): a rotated set is distributed
   * as evenly as before.
   */
  public static double turned(double value, double by) {
    double sum = value + by;
    return sum >= 1 ? sum - 1 : sum;
  }

  /** Hashes an integer by a bijection (Wellons 2018). */
  public static int hash(int value) {
    int h = value;
    h ^= h >>> 16;
    h *= 0x7feb352d;
    h ^= h >>> 15;
    h *= 0x846ca68b;
    return h ^ (h >>> 16);
  }

  /** Returns the second dimension of Sobol's sequence. */
  private static int second(int index) {
    int result = 0;
    int direction = 1 << 31;
    for (int i = index; i != 0; i >>>= 1) {
      if ((i & 1) != 0) {
        result ^= direction;
      }
      direction ^= direction >>> 1;
    }
    return result;
  }

  /**
   * Permutes an index so that aligned blocks of powers of two stay together: the hash carries from
   * low bits to high ones only, hence the bit reversals (Laine and Karras 2011).
   */
  private static int scramble(int index, int seed) {
    int v = Integer.reverse(index);
    v += seed;
    v ^= v * 0x6c50b47c;
    v ^= v * 0xb82f1e52;
    v ^= v * 0xc7afe638;
    v ^= v * 0x8d22f6e6;
    return Integer.reverse(v);
  }

  private static float unit(int bits) {
    return (bits >>> 8) * SCALE;
  }
}
