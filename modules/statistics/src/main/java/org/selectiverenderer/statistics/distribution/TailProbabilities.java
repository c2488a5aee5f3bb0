package org.selectiverenderer.statistics.distribution;

import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.special.Beta;
import org.apache.commons.math3.special.Erf;
import org.apache.commons.math3.special.Gamma;

/**
 * Upper tail probabilities, computed directly, since 1 - P(x) would lose the precision of a small
 * p. All use the incomplete beta and gamma functions (Abramowitz and Stegun 1964, 26.4.19, 26.6.2,
 * 26.7.1).
 */
public final class TailProbabilities {
  private static final double PRECISION = 1e-15;

  private TailProbabilities() {}

  /**
   * Returns P(F &gt; f) for F with df1 and df2 degrees of freedom, which need not be whole.
   *
   * @param f at least 0; may be infinite
   */
  public static double f(double f, double df1, double df2) {
    if (f <= 0) {
      return 1;
    }
    return Double.isInfinite(f)
        ? 0
        : Beta.regularizedBeta(df2 / (df2 + df1 * f), df2 / 2, df1 / 2, PRECISION);
  }

  /** Returns P(T &gt; t) for Student's T and t of any sign. */
  public static double t(double t, double df) {
    double both = Beta.regularizedBeta(df / (df + t * t), df / 2, 0.5, PRECISION);
    return t > 0 ? both / 2 : 1 - both / 2;
  }

  /** Returns P(|T| &gt; |t|) for Student's T. */
  public static double tTwoSided(double t, double df) {
    return 2 * t(Math.abs(t), df);
  }

  /** Returns P(X &gt; x) for chi-squared with df degrees of freedom. */
  public static double chiSquared(double x, double df) {
    return x <= 0 ? 1 : Gamma.regularizedGammaQ(df / 2, x / 2, PRECISION, Integer.MAX_VALUE);
  }

  /** Returns P(Z &gt; z) for a standard normal Z. */
  public static double normal(double z) {
    return Erf.erfc(z / Math.sqrt(2)) / 2;
  }

  /**
   * Returns the half width of a confidence interval around a mean, in standard errors.
   *
   * @param confidence confidence level, 0 to 1
   */
  public static double tQuantile(double confidence, double df) {
    return new TDistribution(null, df).inverseCumulativeProbability((1 + confidence) / 2);
  }
}
