package org.selectiverenderer.statistics.distribution;

import org.apache.commons.math3.analysis.solvers.BrentSolver;
import org.apache.commons.math3.special.Beta;
import org.apache.commons.math3.special.Gamma;

/**
 * The noncentral F distribution: that of F where an effect exists. It is a Poisson mixture of beta
 * distributions (Johnson, Kotz and Balakrishnan 1995, Continuous Univariate Distributions 2, 30.3):
 *
 * <p>P(F &le; f) = sum over j of e^(-l/2) (l/2)^j / j! * I_x(df1/2 + j, df2/2), with x = df1 f /
 * (df1 f + df2) and the noncentrality l.
 *
 * <p>Summed from the largest weight outwards, so that a large l underflows nowhere (Benton and
 * Krishnamoorthy 2003).
 *
 * @param df1 of the effect, above 0
 * @param df2 of the error, above 0
 */
public record NoncentralF(double df1, double df2) {
  private static final double NEGLIGIBLE = 1e-17;
  private static final double RELATIVE = 1e-13;
  private static final double ABSOLUTE = 1e-12;
  private static final int EVALUATIONS = 1000;

  /** Bounds of a noncentrality. */
  public record Interval(double low, double high) {}

  /**
   * P(F &le; f).
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
    int mode = (int) Math.floor(half);
    double sum = 0;
    for (int j = mode; j >= 0; j--) {
      double weight = weight(j, half);
      sum += weight * beta(f, j);
      if (weight < NEGLIGIBLE) {
        break;
      }
    }
    for (int j = mode + 1; ; j++) {
      double weight = weight(j, half);
      double term = weight * beta(f, j);
      sum += term;
      if (weight < NEGLIGIBLE || term < NEGLIGIBLE * sum) {
        return Math.min(1, sum);
      }
    }
  }

  private static double weight(int j, double half) {
    if (half == 0) {
      return j == 0 ? 1 : 0;
    }
    return Math.exp(-half + j * Math.log(half) - Gamma.logGamma(j + 1.0));
  }

  private double beta(double f, int j) {
    double x = df1 * f / (df1 * f + df2);
    return Beta.regularizedBeta(x, df1 / 2 + j, df2 / 2, 1e-15);
  }

  /**
   * The noncentralities for which the observed F lies within the central part of the distribution:
   * an interval of that confidence by inversion of the test (Steiger 2004, Psychological Methods 9;
   * Smithson 2003, Confidence Intervals). A bound that does not exist is 0.
   *
   * @param f observed, finite, at least 0
   * @param confidence from 0 to 1
   */
  public Interval interval(double f, double confidence) {
    double tail = (1 - confidence) / 2;
    return new Interval(where(f, 1 - tail), where(f, tail));
  }

  /** The noncentrality for which P(F &le; f) is that; falls as the noncentrality grows. */
  private double where(double f, double probability) {
    if (cumulative(f, 0) <= probability) {
      return 0;
    }
    double high = Math.max(1, 2 * df1 * f);
    while (cumulative(f, high) > probability) {
      high *= 2;
    }
    return new BrentSolver(RELATIVE, ABSOLUTE)
        .solve(EVALUATIONS, l -> cumulative(f, l) - probability, 0, high);
  }
}
