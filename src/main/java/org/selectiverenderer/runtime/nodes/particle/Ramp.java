package org.selectiverenderer.runtime.nodes.particle;

/** Finds a particle's age among the keys of a ramp. */
final class Ramp {
  private Ramp() {}

  /** The last key that is not above the age, 0 below the first. */
  static int at(float[] key, int count, float life) {
    int low = 0;
    while (low + 1 < count && key[low + 1] <= life) {
      low++;
    }
    return low;
  }

  /** How far the age is from that key to the next one, 0 to 1. */
  static float part(float[] key, int count, int low, float life) {
    if (low + 1 >= count || !(key[low + 1] > key[low])) {
      return 0;
    }
    return Math.max(0, Math.min((life - key[low]) / (key[low + 1] - key[low]), 1));
  }
}
