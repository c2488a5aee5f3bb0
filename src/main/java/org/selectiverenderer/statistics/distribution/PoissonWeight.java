package org.selectiverenderer.statistics.distribution;

import org.apache.commons.math3.special.Gamma;

/**
 * Computes the Poisson probability e^-m m^j / j! without the cancellation of its factors, which for
 * a mean of 1e9 would leave no correct digit: from the deviance of j from the mean and the error of
 * Stirling's formula (Loader 2000, Fast and Accurate Computation of Binomial Probabilities).
 */
final class PoissonWeight {
  private static final double SMALL = 16;
  private static final double NEAR = 0.1;

  private PoissonWeight() {}

  /**
   * Returns the probability of j.
   *
   * @param j at least 0, whole
   * @param mean at least 0
   */
  static double of(double j, double mean) {
    if (j == 0 || mean == 0) {
      return j == 0 ? Math.exp(-mean) : 0;
    }
    return Math.exp(-deviance((j - mean) / mean) * mean - stirling(j)) / Math.sqrt(2 * Math.PI * j);
  }

  /** Returns (1 + t) log(1 + t) - t, by its series where the terms cancel. */
  private static double deviance(double t) {
    if (Math.abs(t) > NEAR) {
      return (1 + t) * Math.log1p(t) - t;
    }
    double sum = 0;
    double power = t;
    for (int k = 2; k < 20; k++) {
      power *= k == 2 ? t : -t;
      sum += power / (k * (k - 1.0));
    }
    return sum;
  }

  /** Returns log j! minus Stirling's formula. */
  private static double stirling(double j) {
    if (j < SMALL) {
      return Gamma.logGamma(j + 1) - (j + 0.5) * Math.log(j) + j - 0.5 * Math.log(2 * Math.PI);
    }
    double square = j * j;
    return (1.0 / 12
            - (1.0 / 360 - (1.0 / 1260 - (1.0 / 1680 - 1.0 / 1188 / square) / square) / square)
                / square)
        / j;
  }
}
