package org.selectiverenderer.browser.nodes.event;

/** Searches the keys of an interpolator or sequencer for a fraction. */
public final class KeyframeSearch {
  private KeyframeSearch() {}

  /**
   * Returns the index of the last key that is not above the fraction; 0 below the first key.
   *
   * @param key the keys in ascending order
   * @param count the number of keys to use, at least 1
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
