package org.selectiverenderer.runtime.render.draw;

import java.util.Arrays;

/**
 * Numbers compared one by one.
 *
 * @param array not written to
 */
record Numbers(float[] array) {
  @Override
  public boolean equals(Object other) {
    return other instanceof Numbers numbers && Arrays.equals(array, numbers.array);
  }

  /** Tells fractions apart, which a FloatBuffer's does not. */
  @Override
  public int hashCode() {
    return Arrays.hashCode(array);
  }
}
