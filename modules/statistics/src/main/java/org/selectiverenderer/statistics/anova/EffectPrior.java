package org.selectiverenderer.statistics.anova;

import java.util.List;

/**
 * The prior of the Bayes factors of effects: effects, in units of the error's standard deviation,
 * have a multivariate Cauchy distribution (Rouder, Morey, Speckman and Province 2012, Journal of
 * Mathematical Psychology 56).
 *
 * @param fixed prior scale r of the fixed effects (the factors), above 0
 * @param random prior scale r of the random effects (the participants), above 0
 * @param seed seed of the Monte Carlo integration, where it is needed
 */
public record EffectPrior(double fixed, double random, long seed) {
  /** The medium and nuisance scales of Morey and Rouder's BayesFactor. */
  public static final EffectPrior MEDIUM = new EffectPrior(0.5, 1, 1);

  /**
   * The prior scales of fixed effects for which a report shows the robustness of the Bayes factors.
   */
  public static final List<Double> ROBUSTNESS =
      List.of(0.2, 0.35, 0.5, Math.sqrt(0.5), 1.0, 1.25, 1.5);

  /** Returns the prior with another scale of the fixed effects. */
  public EffectPrior withFixed(double scale) {
    return new EffectPrior(scale, random, seed);
  }
}
