package org.selectiverenderer.statistics.bayes;

/**
 * The inverse gamma prior of a g, with shape 1/2 and scale r²/2: effects then have a Cauchy prior.
 */
final class InverseGammaPrior {
  private InverseGammaPrior() {}

  /** Returns the logarithm of the density of log g. */
  static double logDensity(double logG, double r) {
    return logConstant(r) - logG / 2 - r * r / 2 * Math.exp(-logG);
  }

  /** Returns the part of the log density that does not depend on g. */
  static double logConstant(double r) {
    return Math.log(r) - 0.5 * Math.log(2 * Math.PI);
  }
}
