package org.selectiverenderer.radiosity.solve;

import org.jspecify.annotations.Nullable;

/**
 * What later iterations would bring: at every patch light comes in steps that soon shrink by one
 * factor, the share that surfaces around it throw back, so their sum is that of a geometric series
 * (Aitken's method).
 */
final class RestOfLight {
  /** Nothing throws back all light: see {@code scene.Reflectance}. */
  private static final double MOST = 0.95;

  private float @Nullable [] last;
  private float @Nullable [] before;
  private float @Nullable [] earlier;

  /**
   * @param irradiance r, g, b per patch after an iteration; it is not changed later
   */
  void heard(float[] irradiance) {
    earlier = before;
    before = last;
    last = irradiance;
  }

  /** The last irradiance with all that is to come; as it is before the third iteration. */
  float[] added() {
    if (last == null) {
      throw new IllegalStateException("no iteration was heard of");
    }
    float[] sum = last.clone();
    if (before == null || earlier == null) {
      return sum;
    }
    for (int i = 0; i < sum.length; i++) {
      double step = last[i] - before[i];
      double stepBefore = before[i] - earlier[i];
      if (step > 0 && stepBefore > 0) {
        double factor = Math.min(MOST, step / stepBefore);
        sum[i] += (float) (step * factor / (1 - factor));
      }
    }
    return sum;
  }
}
