package org.selectiverenderer.statistics.anova;

import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * The four multivariate test statistics that SPSS prints (thesis Figs 93 and 97), computed from the
 * eigenvalues l of E^-1 H, with SPSS's approximations by F (IBM SPSS Statistics Algorithms, GLM,
 * "Multivariate tests"; Rencher 2002, Methods of Multivariate Analysis, 6.1). p is the number of
 * dimensions, q the effect's degrees of freedom, v the error's, s = min(p, q), m = (|p - q| - 1) /
 * 2, n = (v - p - 1) / 2.
 */
public enum MultivariateStatistic {
  /** Sum of l / (1 + l). Pillai 1955, Annals of Mathematical Statistics 26. */
  PILLAI("Pillai's trace") {
    @Override
    MultivariateTest test(double[] l, int p, int q, int v) {
      double value = 0;
      for (double root : l) {
        value += root / (1 + root);
      }
      double s = Math.min(p, q);
      double m = m(p, q);
      double n = n(p, v);
      double f = (2 * n + s + 1) / (2 * m + s + 1) * value / (s - value);
      return finished(value, f, s * (2 * m + s + 1), s * (2 * n + s + 1), s == 1);
    }
  },
  /** Product of 1 / (1 + l). Wilks 1932; F by Rao 1951, exact where min(p, q) is at most 2. */
  WILKS("Wilks' lambda") {
    @Override
    MultivariateTest test(double[] l, int p, int q, int v) {
      double value = 1;
      for (double root : l) {
        value /= 1 + root;
      }
      double squares = (double) p * p + (double) q * q - 5;
      double t = squares > 0 ? Math.sqrt(((double) p * p * q * q - 4) / squares) : 1;
      double df1 = (double) p * q;
      double df2 = (v - (p - q + 1) / 2.0) * t - (p * q - 2) / 2.0;
      double root = Math.pow(value, 1 / t);
      return finished(value, (1 - root) / root * df2 / df1, df1, df2, Math.min(p, q) <= 2);
    }
  },
  /** Sum of l. Hotelling 1951; Lawley 1938; F by Pillai and Samson 1959. */
  HOTELLING("Hotelling's trace") {
    @Override
    MultivariateTest test(double[] l, int p, int q, int v) {
      double value = 0;
      for (double root : l) {
        value += root;
      }
      double s = Math.min(p, q);
      double df1 = s * (2 * m(p, q) + s + 1);
      double df2 = 2 * (s * n(p, v) + 1);
      return finished(value, df2 * value / (s * df1), df1, df2, s == 1);
    }
  },
  /** The largest l. Roy 1953; F is an upper bound unless min(p, q) is 1. */
  ROY("Roy's largest root") {
    @Override
    MultivariateTest test(double[] l, int p, int q, int v) {
      double value = 0;
      for (double root : l) {
        value = Math.max(value, root);
      }
      double r = Math.max(p, q);
      double df2 = v - r + q;
      return finished(value, value * df2 / r, r, df2, Math.min(p, q) == 1);
    }
  };

  private final String title;

  MultivariateStatistic(String title) {
    this.title = title;
  }

  /** Returns the name used in tables. */
  public String title() {
    return title;
  }

  /**
   * Returns the test of the hypothesis with these eigenvalues.
   *
   * @param l eigenvalues of E^-1 H, at least 0
   * @param p dimensions
   * @param q degrees of freedom of the effect
   * @param v degrees of freedom of the error, at least p
   */
  abstract MultivariateTest test(double[] l, int p, int q, int v);

  private static double m(int p, int q) {
    return (Math.abs(p - q) - 1) / 2.0;
  }

  private static double n(int p, int v) {
    return (v - p - 1) / 2.0;
  }

  final MultivariateTest finished(double value, double f, double df1, double df2, boolean exact) {
    double p = df2 > 0 ? TailProbabilities.f(f, df1, df2) : Double.NaN;
    return new MultivariateTest(this, value, df2 > 0 ? f : Double.NaN, df1, df2, p, exact);
  }
}
