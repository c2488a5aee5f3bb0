package org.selectiverenderer.radiosity.solve;

/**
 * The energy balance after an iteration: luminous flux of red, green and blue together, lm.
 *
 * @param iteration number of the iteration, from 1
 * @param emitted flux that arrived directly from the lamps, and flux of other emissive surfaces
 * @param absorbed flux absorbed by surfaces
 * @param escaped flux that left the scene
 * @param unshot flux reflected for the first time in this iteration, to be distributed in the next
 * @param distributed percent of the energy that is distributed; the rest is estimated from its rate
 *     of decrease
 */
public record EnergyBalance(
    int iteration,
    double emitted,
    double absorbed,
    double escaped,
    double unshot,
    double distributed) {

  /**
   * Returns the flux unaccounted for as a share of the emitted flux: the error of the form factors.
   */
  public double discrepancy() {
    return emitted > 0 ? (emitted - absorbed - escaped - unshot) / emitted : 0;
  }
}
