package org.selectiverenderer.statistics.bayes;

/** The prior of a g: inverse gamma with shape 1/2 and scale r²/2, so that effects are Cauchy. */
final class InverseGamma {
  private InverseGamma() {}

  /** Logarithm of the density of log g. */
  static double logDensity(double logG, double r) {
    return logConstant(r) - logG / 2 - r * r / 2 * Math.exp(-logG);
  }

  /** What of it does not depend on g. */
  static double logConstant(double r) {
    return Math.log(r) - 0.5 * Math.log(2 * Math.PI);
  }
}
