package org.selectiverenderer.models.scene;

import java.util.Arrays;

/**
 * Values over time, linear between keys. The arrays must not be modified.
 *
 * @param times seconds, not decreasing, at least one
 * @param values {@code size} numbers for each time
 * @param size the numbers of a value
 */
public record Keyframes(float[] times, float[] values, int size) {
  /** Returns the last time in seconds. */
  public float end() {
    return times[times.length - 1];
  }

  /** Returns the keys as fractions of a duration in seconds. */
  float[] fractions(double duration) {
    float[] keys = new float[times.length];
    for (int i = 0; i < keys.length; i++) {
      keys[i] = duration > 0 ? (float) Numbers.unit(times[i] / duration) : 0;
    }
    return keys;
  }

  /** Returns the value of a key. */
  public float[] value(int key) {
    return Arrays.copyOfRange(values, key * size, (key + 1) * size);
  }
}
