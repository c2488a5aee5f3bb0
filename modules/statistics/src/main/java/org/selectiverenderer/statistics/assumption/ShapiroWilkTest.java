package org.selectiverenderer.statistics.assumption;

import java.util.Arrays;
import java.util.Optional;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.stat.StatUtils;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * The Shapiro-Wilk test of normality (Shapiro and Wilk 1965, Biometrika 52), with Royston's
 * approximations of its coefficients and of p for 3 to 5000 values (1995, Applied Statistics 44, AS
 * R94).
 *
 * @param at the within level; empty when there is one only
 * @param w the test statistic W, 0 to 1; 1 for values spaced as normal order statistics
 */
public record ShapiroWilkTest(Optional<String> at, double w, double p) {
  private static final int FEWEST = 3;
  private static final int MOST = 5000;
  private static final int FEW = 11;
  private static final double[] FIRST = {0, 0.221157, -0.147981, -2.07119, 4.434685, -2.706056};
  private static final double[] SECOND = {0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633};
  private static final double[] FEW_MEAN = {0.544, -0.39978, 0.025054, -6.714e-4};
  private static final double[] FEW_LOG_SD = {1.3822, -0.77857, 0.062767, -0.0020322};
  private static final double[] MANY_MEAN = {-1.5861, -0.31082, -0.083751, 0.0038915};
  private static final double[] MANY_LOG_SD = {-0.4803, -0.082676, 0.0030302};
  private static final double[] FEW_SHIFT = {-2.273, 0.459};

  /** Runs the test; empty if there are too few or too many values, or they do not vary. */
  static Optional<ShapiroWilkTest> of(Optional<String> at, double[] values) {
    int n = values.length;
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    double mean = StatUtils.mean(sorted);
    double squares = Arrays.stream(sorted).map(x -> (x - mean) * (x - mean)).sum();
    if (n < FEWEST || n > MOST || !(squares > 0)) {
      return Optional.empty();
    }
    double[] a = coefficients(n);
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * (sorted[n - 1 - i] - sorted[i]);
    }
    double w = Math.min(1, sum * sum / squares);
    return Optional.of(new ShapiroWilkTest(at, w, p(w, n)));
  }

  /**
   * Returns the coefficients of the differences between the largest and the smallest value, the
   * next inner pair, and so on.
   */
  private static double[] coefficients(int n) {
    if (n == FEWEST) {
      return new double[] {Math.sqrt(0.5)};
    }
    NormalDistribution normal = new NormalDistribution(null, 0, 1);
    double[] m = new double[n / 2];
    double squares = 0;
    for (int i = 0; i < m.length; i++) {
      m[i] = -normal.inverseCumulativeProbability((i + 1 - 0.375) / (n + 0.25));
      squares += 2 * m[i] * m[i];
    }
    double length = Math.sqrt(squares);
    double root = 1 / Math.sqrt(n);
    double[] a = m.clone();
    a[0] = polynomial(FIRST, root) + m[0] / length;
    int corrected = n > 5 ? 2 : 1;
    double left = squares - 2 * m[0] * m[0];
    double share = 1 - 2 * a[0] * a[0];
    if (corrected == 2) {
      a[1] = polynomial(SECOND, root) + m[1] / length;
      left -= 2 * m[1] * m[1];
      share -= 2 * a[1] * a[1];
    }
    for (int i = corrected; i < a.length; i++) {
      a[i] = m[i] / Math.sqrt(left / share);
    }
    return a;
  }

  private static double p(double w, int n) {
    if (n == FEWEST) {
      double p = 6 / Math.PI * (Math.asin(Math.sqrt(w)) - Math.asin(Math.sqrt(0.75)));
      return Math.max(0, p);
    }
    double y = Math.log1p(-w);
    double log = Math.log(n);
    if (n > FEW) {
      return TailProbabilities.normal(
          (y - polynomial(MANY_MEAN, log)) / Math.exp(polynomial(MANY_LOG_SD, log)));
    }
    double shift = polynomial(FEW_SHIFT, n);
    return y >= shift
        ? 0
        : TailProbabilities.normal(
            (-Math.log(shift - y) - polynomial(FEW_MEAN, n)) / Math.exp(polynomial(FEW_LOG_SD, n)));
  }

  private static double polynomial(double[] coefficients, double x) {
    double sum = 0;
    for (int i = coefficients.length - 1; i >= 0; i--) {
      sum = sum * x + coefficients[i];
    }
    return sum;
  }
}
