package org.selectiverenderer.radiosity.solve;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Estimates the remainder of the Neumann series, the light that later iterations would add: its
 * terms soon shrink by a constant factor, the mean reflectance of the scene, so the remainder is
 * that of a geometric series. The factor is that of the whole scene, since where little light
 * arrives early, as under a table, a patch's own terms do not shrink yet.
 */
final class RestOfLight {
  /** Largest factor: see {@code scene.Reflectance}. */
  private static final double MOST = 0.95;

  private float @Nullable [] last;
  private float @Nullable [] before;

  /**
   * @param irradiance r, g, b of each patch after an iteration; it must not be changed later
   */
  void heard(float[] irradiance) {
    before = last;
    last = irradiance;
  }

  /**
   * Returns the last irradiance plus the estimated remainder; after the first iteration the
   * irradiance as it is.
   *
   * @param balances the energy balances of all iterations
   */
  float[] added(List<EnergyBalance> balances) {
    if (last == null) {
      throw new IllegalStateException("no iteration has been added");
    }
    float[] sum = last.clone();
    int count = balances.size();
    if (before == null || count < 2 || !(balances.get(count - 2).unshot() > 0)) {
      return sum;
    }
    double shrinks = balances.get(count - 1).unshot() / balances.get(count - 2).unshot();
    double factor = Math.max(0, Math.min(MOST, shrinks));
    for (int i = 0; i < sum.length; i++) {
      sum[i] += (float) (Math.max(0, last[i] - before[i]) * factor / (1 - factor));
    }
    return sum;
  }
}
