package org.selectiverenderer.render.draw;

import java.util.Arrays;

/**
 * An array of floats as a map key, compared by value.
 *
 * @param array not written to
 */
record FloatArrayKey(float[] array) {
  @Override
  public boolean equals(Object other) {
    return other instanceof FloatArrayKey numbers && Arrays.equals(array, numbers.array);
  }

  /** Distributes well: the hash code of a FloatBuffer ignores fractions. */
  @Override
  public int hashCode() {
    return Arrays.hashCode(array);
  }
}
