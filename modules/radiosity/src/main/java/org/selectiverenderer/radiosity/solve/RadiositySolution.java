package org.selectiverenderer.radiosity.solve;

import java.util.List;

/**
 * The radiosity solution: the light on each patch.
 *
 * <p>Radiance is that of the opaque share of a surface, which stops a ray: for a pane that
 * transmits three quarters of the light it is the radiance of the remaining quarter.
 *
 * @param reflected reflected radiance r, g, b of each patch, cd/m2
 * @param glow emitted radiance r, g, b of each patch that is not one of the lamps, cd/m2
 * @param direct irradiance r, g, b of each patch from the lamps, lx
 * @param indirect irradiance r, g, b of each patch from other surfaces, lx
 * @param lampsOf per patch, bit i: whether some part of lamp i is visible from it
 * @param buried per patch: whether it lies inside of a solid
 * @param balances the energy balance of each iteration
 */
public record RadiositySolution(
    SurfacePatches patches,
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
