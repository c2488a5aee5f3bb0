package org.selectiverenderer.statistics.distribution;

/**
 * The distribution of the studentized range: the largest of several means less the smallest, in
 * units of their standard error (Tukey's test; Copenhaver and Holland 1988, Journal of Statistical
 * Computation and Simulation 30).
 *
 * @param means number of means, at least 2
 * @param df degrees of freedom of the error, above 0
 */
public record StudentizedRange(int means, double df) {
  private static final double STEP = 0.3;
  private static final int POINTS = 57;

  /**
   * Returns P(Q &gt; q), computed directly so that small values keep their precision.
   *
   * @param q at least 0
   */
  public double upper(double q) {
    if (q <= 0) {
      return 1;
    }
    double[] below = new double[POINTS];
    double[] weights = new double[POINTS];
    for (int i = 0; i < POINTS; i++) {
      below[i] = TailProbabilities.normal(-z(i));
      weights[i] =
          means
              * STEP
              * Math.exp(-z(i) * z(i) / 2)
              / Math.sqrt(2 * Math.PI)
              * Math.pow(below[i], means - 1.0);
    }
    LogChiDistribution chi = new LogChiDistribution(df);
    return Math.min(
        1,
        TrapezoidalRule.of(
            u -> chi.density(u) * ofNormals(q * Math.exp(u), below, weights), 0, chi.step()));
  }

  private static double z(int i) {
    return (i - (POINTS - 1) / 2.0) * STEP;
  }

  /**
   * Returns the upper tail of the range of standard normal variables: the integral of c φ(z)
   * (Φ(z)^(c-1) - (Φ(z) - Φ(z - w))^(c-1)), z the largest of them.
   */
  private double ofNormals(double w, double[] below, double[] weights) {
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
      double share = Math.min(1, TailProbabilities.normal(w - z(i)) / below[i]);
      sum += weights[i] * (share == 1 ? 1 : -Math.expm1((means - 1) * Math.log1p(-share)));
    }
    return Math.min(1, sum);
  }
}
