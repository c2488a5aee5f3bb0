package org.selectiverenderer.radiosity.solve;

/**
 * Where the light is after an iteration, lm; luminous flux of red, green and blue together.
 *
 * @param iteration from 1
 * @param emitted what has arrived straight from the lamps, and what else glows
 * @param absorbed by the surfaces
 * @param escaped out of the scene
 * @param unshot reflected for the first time in this iteration, to be passed on in the next
 * @param distributed percent of the energy that is distributed, the rest estimated from how fast it
 *     falls
 */
public record EnergyBalance(
    int iteration,
    double emitted,
    double absorbed,
    double escaped,
    double unshot,
    double distributed) {

  /** What is unaccounted for, as a share of what is emitted: the error of the form factors. */
  public double discrepancy() {
    return emitted > 0 ? (emitted - absorbed - escaped - unshot) / emitted : 0;
  }
}
