package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.AtomicIntegerArray;

/**
 * A histogram of the texels' noise, filled by several threads; integer counts give the same sums in
 * any order.
 */
final class NoiseCount {
  /** Width of a bin, as a share of the light. The last of the bins takes all larger values. */
  private static final double STEP = 1e-4;

  private final AtomicIntegerArray texels = new AtomicIntegerArray(2_000);

  /**
   * @param share the standard error of a texel, as a share of its light
   */
  void add(double share) {
    texels.incrementAndGet((int) Math.max(0, Math.min(texels.length() - 1, share / STEP)));
  }

  /**
   * @param places number of irradiance records
   */
  TexelNoise of(int places) {
    long all = 0;
    double sum = 0;
    for (int i = 0; i < texels.length(); i++) {
      all += texels.get(i);
      sum += texels.get(i) * (i + 0.5) * STEP;
    }
    if (all == 0) {
      return TexelNoise.NONE;
    }
    long below = 0;
    int most = 0;
    while (below + texels.get(most) < 0.95 * all) {
      below += texels.get(most++);
    }
    return new TexelNoise(sum / all, (most + 1) * STEP, places);
  }
}
