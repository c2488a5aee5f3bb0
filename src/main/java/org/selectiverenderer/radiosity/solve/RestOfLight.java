package org.selectiverenderer.radiosity.solve;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What later iterations would bring: light comes in steps that soon shrink by one factor, the share
 * that the scene's surfaces throw back, so their sum is that of a geometric series. The factor is
 * that of the whole scene: where little light comes early, as under a table, a patch's own steps do
 * not shrink yet.
 */
final class RestOfLight {
  /** Nothing throws back all light: see {@code scene.Reflectance}. */
  private static final double MOST = 0.95;

  private float @Nullable [] last;
  private float @Nullable [] before;

  /**
   * @param irradiance r, g, b per patch after an iteration; it is not changed later
   */
  void heard(float[] irradiance) {
    before = last;
    last = irradiance;
  }

  /**
   * The last irradiance with all that is to come; as it is after the first iteration.
   *
   * @param balances of all iterations
   */
  float[] added(List<EnergyBalance> balances) {
    if (last == null) {
      throw new IllegalStateException("no iteration was heard of");
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
