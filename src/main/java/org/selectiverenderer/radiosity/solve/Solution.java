package org.selectiverenderer.radiosity.solve;

import java.util.List;

/**
 * The light on the patches.
 *
 * <p>Radiance is that of the opaque part, which a ray meets that is not let through: of a pane that
 * lets through three quarters it is what the remaining quarter has.
 *
 * @param reflected radiance r, g, b per patch of what is reflected, cd/m2
 * @param glow radiance r, g, b per patch of what glows and is not among the lamps, cd/m2
 * @param direct irradiance r, g, b per patch by the lamps, lx
 * @param indirect irradiance r, g, b per patch by other surfaces, lx
 * @param lampsOf per patch, bit i: whether it sees some of lamp i
 * @param buried per patch: whether it lies inside of something
 * @param balances one per iteration
 */
public record Solution(
    LightPatches patches,
    float[] reflected,
    float[] glow,
    float[] direct,
    float[] indirect,
    long[] lampsOf,
    boolean[] buried,
    List<EnergyBalance> balances) {

  public EnergyBalance last() {
    return balances.get(balances.size() - 1);
  }
}
