package org.selectiverenderer.statistics.distribution;

import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.special.Gamma;

/**
 * The noncentral t distribution: the distribution of t = (Z + d) / S, where Z is standard normal, S
 * the square root of a chi-squared variable over its degrees of freedom, and d the noncentrality.
 *
 * <p>P(T &le; t) is one integral, over S or over Z; the one whose integrand is the smoother is
 * taken.
 *
 * @param df degrees of freedom, above 0
 */
public record NoncentralT(double df) {
  private static final double Z_STEP = 0.1;
  private static final double Z_END = 9;
  private static final double PRECISION = 1e-15;
  private static final double ACCURACY = 1e-12;
  private static final int EVALUATIONS = 1000;

  /** A confidence interval of the noncentrality. */
  public record Interval(double low, double high) {}

  /** Returns P(T &le; t) for t of any sign. */
  public double cumulative(double t, double noncentrality) {
    if (t < 0) {
      return 1 - cumulative(-t, -noncentrality);
    }
    return t > Math.sqrt(2 * df) ? overNormal(t, noncentrality) : overDeviation(t, noncentrality);
  }

  private double overDeviation(double t, double noncentrality) {
    LogChiDistribution chi = new LogChiDistribution(df);
    return Math.min(
        1,
        TrapezoidalRule.of(
            u -> chi.density(u) * TailProbabilities.normal(noncentrality - t * Math.exp(u)),
            0,
            chi.step()));
  }

  /** Integrates over Z: T is below t where Z is below -d, or S above (Z + d) / t. */
  private double overNormal(double t, double noncentrality) {
    double sum = 0;
    for (double z = -Z_END; z <= Z_END; z += Z_STEP) {
      double s = Math.max(0, (z + noncentrality) / t);
      sum +=
          Math.exp(-z * z / 2)
              * (s == 0
                  ? 1
                  : Gamma.regularizedGammaQ(df / 2, df * s * s / 2, PRECISION, Integer.MAX_VALUE));
    }
    return Math.min(1, sum * Z_STEP / Math.sqrt(2 * Math.PI));
  }

  /**
   * Returns the confidence interval of the noncentrality by inversion of the test: the
   * noncentralities for which the observed t lies within the central part of the distribution
   * (Steiger and Fouladi 1997).
   *
   * @param t observed t, finite
   * @param confidence confidence level, 0 to 1
   */
  public Interval interval(double t, double confidence) {
    double tail = (1 - confidence) / 2;
    return new Interval(where(t, 1 - tail), where(t, tail));
  }

  /**
   * Returns the noncentrality for which P(T &le; t) has the given value; that probability falls as
   * the noncentrality grows.
   */
  private double where(double t, double probability) {
    double width = Math.sqrt(1 + t * t / (2 * df));
    double low = t - width;
    double high = t + width;
    while (cumulative(t, low) < probability) {
      low -= width;
    }
    while (cumulative(t, high) > probability) {
      high += width;
    }
    return new BrentSolver(ACCURACY, ACCURACY)
        .solve(EVALUATIONS, d -> cumulative(t, d) - probability, low, high);
  }
}
