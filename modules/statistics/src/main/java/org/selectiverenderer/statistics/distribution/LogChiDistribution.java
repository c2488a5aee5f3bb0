package org.selectiverenderer.statistics.distribution;

import org.apache.commons.math3.special.Gamma;

/**
 * The distribution of the logarithm u of an estimated standard deviation with df degrees of freedom
 * whose true value is 1.
 */
final class LogChiDistribution {
  private final double df;
  private final double constant;

  LogChiDistribution(double df) {
    this.df = df;
    constant = Math.log(2) + df / 2 * Math.log(df / 2) - Gamma.logGamma(df / 2);
  }

  /** Returns the density of u. */
  double density(double u) {
    return Math.exp(constant + df * u - df * Math.exp(2 * u) / 2);
  }

  /** Returns a step that resolves the density, whose standard deviation is about 1 / sqrt(2 df). */
  double step() {
    return Math.min(0.12, 0.4 / Math.sqrt(2 * df));
  }
}
