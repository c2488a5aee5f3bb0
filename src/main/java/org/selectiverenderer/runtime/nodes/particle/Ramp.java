package org.selectiverenderer.runtime.nodes.particle;

/** Searches the keys of a colour or texture coordinate ramp for a particle's age. */
final class Ramp {
  private Ramp() {}

  /** Returns the index of the last key that is not above the age; 0 below the first key. */
  static int at(float[] key, int count, float life) {
    int low = 0;
    while (low + 1 < count && key[low + 1] <= life) {
      low++;
    }
    return low;
  }

  /** Returns the position of the age between that key and the next, 0 to 1. */
  static float part(float[] key, int count, int low, float life) {
    if (low + 1 >= count || !(key[low + 1] > key[low])) {
      return 0;
    }
    return Math.max(0, Math.min((life - key[low]) / (key[low + 1] - key[low]), 1));
  }
}
