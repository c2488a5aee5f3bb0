package org.selectiverenderer.statistics.anova;

/** Computes the JZS Bayes factor of a t test. BF01 above 1 is evidence for the null hypothesis. */
final class JzsT {
  private static final double FIRST = -30;
  private static final double STEP = 0.04;
  private static final double LAST = 4;

  private JzsT() {}

  /**
   * Returns BF01 of a t statistic with the prior of Jeffreys, Zellner and Siow: the standardised
   * difference has a Cauchy distribution with the given scale (Rouder, Speckman, Sun, Morey and
   * Iverson 2009, Psychonomic Bulletin and Review 16, equation 1; the scale as in their appendix).
   *
   * <p>The integral over g is taken with g = 1/u², u = e^s, in equal steps of s: the integrand
   * decays at both ends faster than any exponential, where that rule converges to machine
   * precision.
   *
   * @param n effective size: n1 n2 / (n1 + n2) for two groups, the number of pairs for pairs
   * @param scale scale of the Cauchy prior, by default 0.707
   */
  static double nullFactor(double t, double df, double n, double scale) {
    double power = -(df + 1) / 2;
    double nullLog = power * Math.log1p(t * t / df);
    double shift = n * scale * scale;
    double alternative = 0;
    for (double s = FIRST; s < LAST; s += STEP) {
      double u = Math.exp(s);
      double g = shift / (u * u);
      double log =
          -0.5 * Math.log1p(g)
              + power * Math.log1p(t * t / ((1 + g) * df))
              - nullLog
              - u * u / 2
              + s;
      alternative += Math.exp(log) * STEP;
    }
    return 1 / (alternative * 2 / Math.sqrt(2 * Math.PI));
  }
}
