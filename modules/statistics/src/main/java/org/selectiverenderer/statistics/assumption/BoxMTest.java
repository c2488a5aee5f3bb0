package org.selectiverenderer.statistics.assumption;

import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.stat.correlation.Covariance;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * Box's M test of equal covariance matrices of the within levels in the groups, with the
 * chi-squared approximation (Box 1949, Biometrika 36; Rencher 2002, Methods of Multivariate
 * Analysis, 7.3.2). The test is very sensitive, so 0.001 is its customary significance level.
 */
public record BoxMTest(double m, double chiSquared, double df, double p) {
  /**
   * Runs the test.
   *
   * @param groups for each group, a row for each subject and a column for each within level
   * @return empty if a group has too few subjects to estimate its covariances
   */
  static Optional<BoxMTest> of(List<double[][]> groups) {
    int p = groups.get(0)[0].length;
    double g = groups.size();
    double all = 0;
    double logs = 0;
    double inverses = 0;
    Optional<RealMatrix> pooled = Optional.empty();
    for (double[][] group : groups) {
      double df = group.length - 1.0;
      if (df < p) {
        return Optional.empty();
      }
      RealMatrix own = new Covariance(group).getCovarianceMatrix();
      double log = logDeterminant(own);
      if (!Double.isFinite(log)) {
        return Optional.empty();
      }
      all += df;
      logs += df * log;
      inverses += 1 / df;
      RealMatrix sum = own.scalarMultiply(df);
      pooled = Optional.of(pooled.map(sum::add).orElse(sum));
    }
    double m = all * logDeterminant(pooled.orElseThrow().scalarMultiply(1 / all)) - logs;
    double scale = (inverses - 1 / all) * (2.0 * p * p + 3.0 * p - 1) / (6 * (p + 1.0) * (g - 1));
    double df = p * (p + 1.0) * (g - 1) / 2;
    double chiSquared = m * (1 - scale);
    return Optional.of(
        new BoxMTest(m, chiSquared, df, TailProbabilities.chiSquared(chiSquared, df)));
  }

  /** Returns the logarithm of the determinant; minus infinity for a singular matrix. */
  private static double logDeterminant(RealMatrix matrix) {
    double[] roots = new EigenDecomposition(matrix).getRealEigenvalues();
    double largest = 0;
    for (double root : roots) {
      largest = Math.max(largest, root);
    }
    double log = 0;
    for (double root : roots) {
      log += root > 1e-12 * largest ? Math.log(root) : Double.NEGATIVE_INFINITY;
    }
    return log;
  }
}
