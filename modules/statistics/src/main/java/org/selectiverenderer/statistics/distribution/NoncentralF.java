package org.selectiverenderer.statistics.distribution;

import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.special.Beta;
import org.apache.commons.math3.special.Gamma;

/**
 * The noncentral F distribution: the distribution of F where an effect exists. It is a Poisson
 * mixture of beta distributions (Johnson, Kotz and Balakrishnan 1995, Continuous Univariate
 * Distributions 2, 30.3):
 *
 * <p>P(F &le; f) = sum over j of e^(-l/2) (l/2)^j / j! * I_x(df1/2 + j, df2/2), with x = df1 f /
 * (df1 f + df2) and the noncentrality l.
 *
 * <p>The sum runs from the largest weight outwards, so that it does not underflow for a large l
 * (Benton and Krishnamoorthy 2003). Where l is large, both factors change slowly with j: the sum is
 * then taken at every h-th j, which is the trapezoidal rule for a smooth function, so that a sum
 * has some hundred terms for any l.
 *
 * @param df1 degrees of freedom of the effect, above 0
 * @param df2 degrees of freedom of the error, above 0
 */
public record NoncentralF(double df1, double df2) {
  private static final double NEGLIGIBLE = 1e-17;
  private static final double RELATIVE = 1e-13;
  private static final double ABSOLUTE = 1e-12;
  private static final double PRECISION = 1e-15;
  private static final int EVALUATIONS = 1000;

  /**
   * Number of terms per standard deviation of the weights; the error of the trapezoidal rule is
   * then below e^-100.
   */
  private static final double DENSITY = 3;

  /**
   * Wise's formula is used where the first parameter of the beta distribution is this many times
   * the second.
   */
  private static final double WISE = 1e5;

  /** A confidence interval of the noncentrality. */
  public record Interval(double low, double high) {}

  /**
   * Returns P(F &le; f).
   *
   * @param noncentrality at least 0
   */
  public double cumulative(double f, double noncentrality) {
    if (f <= 0) {
      return 0;
    }
    if (Double.isInfinite(f)) {
      return 1;
    }
    double half = noncentrality / 2;
    double mode = Math.floor(half);
    double stride = stride(half);
    double sum = 0;
    for (double j = mode; j >= 0; j -= stride) {
      double weight = PoissonProbability.of(j, half) * stride;
      sum += weight * beta(f, j);
      if (weight < NEGLIGIBLE) {
        break;
      }
    }
    for (double j = mode + stride; ; j += stride) {
      double weight = PoissonProbability.of(j, half) * stride;
      double term = weight * beta(f, j);
      sum += term;
      if (weight < NEGLIGIBLE || term < NEGLIGIBLE * sum) {
        return Math.min(1, sum);
      }
    }
  }

  /**
   * Returns the spacing h of the summed terms. The standard deviation of the weights is sqrt(m),
   * the width of the step in the beta factors m / sqrt(df2 / 2).
   */
  private double stride(double half) {
    double width = Math.min(Math.sqrt(half), half / Math.sqrt(Math.max(1, df2 / 2)));
    return Math.max(1, Math.floor(width / DENSITY));
  }

  /**
   * Returns I_x(a, b). Where a is by far the larger, x is too near to 1 for the precision of a
   * double; it is then computed by the first term of Wise's series: the upper tail of gamma(b) at
   * -(a + (b - 1) / 2) log x (Wise 1950, Biometrika 37), whose error is of the order (b / a)².
   */
  private double beta(double f, double j) {
    double a = df1 / 2 + j;
    double b = df2 / 2;
    if (a > WISE * Math.max(1, b)) {
      double above = df2 / (df1 * f + df2);
      double scaled = -(a + (b - 1) / 2) * Math.log1p(-above);
      return Gamma.regularizedGammaQ(b, scaled, PRECISION, Integer.MAX_VALUE);
    }
    return Beta.regularizedBeta(df1 * f / (df1 * f + df2), a, b, PRECISION);
  }

  /**
   * Returns the confidence interval of the noncentrality by inversion of the test: the
   * noncentralities for which the observed F lies within the central part of the distribution
   * (Steiger 2004, Psychological Methods 9; Smithson 2003, Confidence Intervals). A bound that does
   * not exist is 0.
   *
   * @param f observed F, finite, at least 0
   * @param confidence confidence level, 0 to 1
   */
  public Interval interval(double f, double confidence) {
    double tail = (1 - confidence) / 2;
    return new Interval(where(f, 1 - tail), where(f, tail));
  }

  /**
   * Returns the noncentrality for which P(F &le; f) has the given value; that probability falls as
   * the noncentrality grows.
   */
  private double where(double f, double probability) {
    if (cumulative(f, 0) <= probability) {
      return 0;
    }
    double low = 0;
    double high = Math.max(1, df1 * f);
    while (cumulative(f, high) > probability) {
      low = high;
      high *= 2;
    }
    return new BrentSolver(RELATIVE, ABSOLUTE)
        .solve(EVALUATIONS, l -> cumulative(f, l) - probability, low, high);
  }

  /**
   * Computes the Poisson probability e^-m m^j / j! without the cancellation of its factors, which
   * for a mean of 1e9 would leave no correct digit: from the deviance of j from the mean and the
   * error of Stirling's formula (Loader 2000, Fast and Accurate Computation of Binomial
   * Probabilities).
   */
  private static final class PoissonProbability {
    private static final double SMALL = 16;
    private static final double NEAR = 0.1;

    private PoissonProbability() {}

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
      return Math.exp(-deviance((j - mean) / mean) * mean - stirling(j))
          / Math.sqrt(2 * Math.PI * j);
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
}
