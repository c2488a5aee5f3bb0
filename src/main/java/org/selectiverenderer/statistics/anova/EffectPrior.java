package org.selectiverenderer.statistics.anova;

import java.util.List;

/**
 * The prior of the Bayes factors of effects: effects in standard deviations of the error are
 * multivariate Cauchy distributed (Rouder, Morey, Speckman and Province 2012, Journal of
 * Mathematical Psychology 56).
 *
 * @param fixed scale of the factors' effects, above 0
 * @param random scale of the participants' effects, above 0
 * @param seed of the Monte Carlo integral, where one is needed
 */
public record EffectPrior(double fixed, double random, long seed) {
  /** The medium and nuisance scales of Morey and Rouder's BayesFactor. */
  public static final EffectPrior MEDIUM = new EffectPrior(0.5, 1, 1);

  /** Scales of factors' effects for which a report tells how much the prior matters. */
  public static final List<Double> ROBUSTNESS =
      List.of(0.2, 0.35, 0.5, Math.sqrt(0.5), 1.0, 1.25, 1.5);

  /** With another scale of the factors' effects. */
  public EffectPrior withFixed(double scale) {
    return new EffectPrior(scale, random, seed);
  }
}
