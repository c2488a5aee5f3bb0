package org.selectiverenderer.statistics.distribution;

/**
 * The studentized range: the largest of some means less the smallest, in standard errors (Tukey's
 * test; Copenhaver and Holland 1988, Journal of Statistical Computation and Simulation 30).
 *
 * @param means how many, at least 2
 * @param df of the error, above 0
 */
public record StudentizedRange(int means, double df) {
  private static final double Z_STEP = 0.2;
  private static final double Z_END = 9;

  /**
   * P(Q &gt; q), computed as such: small ones keep their digits.
   *
   * @param q at least 0
   */
  public double upper(double q) {
    if (q <= 0) {
      return 1;
    }
    Chi chi = new Chi(df);
    return Math.min(
        1, Trapezoid.of(u -> chi.density(u) * ofNormals(q * Math.exp(u)), 0, chi.step()));
  }

  /**
   * The tail of the range of standard normals: the integral of c φ(z) (Φ(z)^(c-1) - (Φ(z) - Φ(z -
   * w))^(c-1)), z the largest of them.
   */
  private double ofNormals(double w) {
    double sum = 0;
    for (double z = -Z_END; z <= Z_END; z += Z_STEP) {
      double below = Tails.normal(-z);
      double apart = Tails.normal(w - z);
      double share = Math.min(1, apart / below);
      double one =
          share == 1
              ? 1
              : -Math.expm1((means - 1) * Math.log1p(-share));
      sum += Math.exp(-z * z / 2) * Math.pow(below, means - 1.0) * one;
    }
    return Math.min(1, means * sum * Z_STEP / Math.sqrt(2 * Math.PI));
  }
}
