package org.selectiverenderer.runtime.nodes.event;

/** Finds a fraction among the keys of an interpolator or sequencer. */
public final class KeyFrames {
  private KeyFrames() {}

  /**
   * The index of the last key that is not above the fraction, 0 below the first key.
   *
   * @param key in ascending order
   * @param count how many keys count, at least 1
   */
  public static int at(float[] key, int count, float fraction) {
    int low = 0;
    int high = count - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (key[middle] <= fraction) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}
