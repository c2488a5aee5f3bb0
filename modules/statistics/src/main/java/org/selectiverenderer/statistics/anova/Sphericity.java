package org.selectiverenderer.statistics.anova;

import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * Mauchly's test of sphericity of the contrasts between three or more within levels (that they have
 * equal variances and no covariances, as F assumes), and the epsilons that correct the degrees of
 * freedom.
 *
 * @param mauchlyW Mauchly 1940, Annals of Mathematical Statistics 11; 0 to 1, 1 is sphericity
 * @param mauchlyP p of W by the second-order chi-squared approximation (Anderson 2003, Multivariate
 *     Statistical Analysis, 10.7.4); NaN when there are too few subjects for the contrasts
 * @param greenhouseGeisser epsilon: Box 1954; Greenhouse and Geisser 1959, Psychometrika 24
 * @param huynhFeldt epsilon: Huynh and Feldt 1976, Journal of Educational Statistics 1, with
 *     Lecoutre's 1991 correction for several groups; at most 1
 */
public record Sphericity(
    double mauchlyW, double mauchlyP, double greenhouseGeisser, double huynhFeldt) {
  static Sphericity of(LinearHypothesis hypothesis) {
    int q = hypothesis.dimensions();
    int df = hypothesis.errorDf();
    RealMatrix s = hypothesis.error().scalarMultiply(1.0 / df);
    double trace = s.getTrace();
    double epsilon = trace * trace / (q * s.multiply(s).getTrace());
    double corrected = ((df + 1) * q * epsilon - 2) / (q * (df - q * epsilon));
    double huynhFeldt = corrected > 0 ? Math.min(1, corrected) : 1;
    double w = new LUDecomposition(s, 0).getDeterminant() / Math.pow(trace / q, q);
    return new Sphericity(w, df >= q ? mauchlyP(w, q, df) : Double.NaN, epsilon, huynhFeldt);
  }

  private static double mauchlyP(double w, int q, int df) {
    double rho = 1 - (2.0 * q * q + q + 2) / (6.0 * q * df);
    double second =
        (q + 2.0)
            * (q - 1.0)
            * (q - 2.0)
            * (2.0 * q * q * q + 6.0 * q * q + 3.0 * q + 2)
            / (288 * Math.pow(q * df * rho, 2));
    double statistic = -df * rho * Math.log(w);
    double f = q * (q + 1) / 2.0 - 1;
    double p = TailProbabilities.chiSquared(statistic, f);
    return Math.min(1, p + second * (TailProbabilities.chiSquared(statistic, f + 4) - p));
  }
}
