package org.selectiverenderer.statistics.anova;

import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.statistics.distribution.NoncentralT;
import org.selectiverenderer.statistics.distribution.StudentizedRange;

/**
 * A comparison of two levels of a factor with the pooled error of the design.
 *
 * @param factor name of the factor whose levels are compared; {@code within x between} for
 *     interaction contrasts (differences of differences)
 * @param at the level of another factor at which the levels are compared; empty: over all its
 *     levels, with equal weights
 * @param difference mean of the first level less that of the second, in the measure's units
 * @param low lower bound of the confidence interval of the difference, not adjusted
 * @param p two-sided p, not adjusted for multiple comparisons
 * @param family the family of comparisons that this one belongs to, with its p after Holm
 * @param deviation pooled standard deviation of the scores within a cell
 * @param confidence confidence level of the intervals, 0 to 1
 * @param size effective number of subjects: n1 n2 / (n1 + n2) for two groups, the number of pairs
 *     for pairs
 * @param priorScale scale of the Cauchy prior of the Bayes factor
 */
public record PairwiseComparison(
    String factor,
    Optional<String> at,
    String first,
    String second,
    double difference,
    double standardError,
    double df,
    double low,
    double high,
    double t,
    double p,
    Family family,
    double deviation,
    double confidence,
    Tost tost,
    double size,
    double priorScale) {
  /**
   * A family of comparisons whose familywise error rate is controlled.
   *
   * @param size number of comparisons
   * @param means number of levels if the family is all pairs of levels; 0 otherwise
   * @param holm p of this comparison after Holm (1979)
   */
  public record Family(int size, int means, double holm) {}

  PairwiseComparison inFamily(int members, double holm) {
    return new PairwiseComparison(
        factor,
        at,
        first,
        second,
        difference,
        standardError,
        df,
        low,
        high,
        t,
        p,
        new Family(members, family.means(), holm),
        deviation,
        confidence,
        tost,
        size,
        priorScale);
  }

  /** Returns BF01 with the prior of Jeffreys, Zellner and Siow (JZS); NaN where t is NaN. */
  public double bayesFactor() {
    return Double.isFinite(t) ? JzsBayesFactor.nullFactor(t, df, size, priorScale) : Double.NaN;
  }

  /** Returns p after Holm. */
  public double holm() {
    return family.holm();
  }

  /** Returns p times the family's size (Bonferroni), at most 1. */
  public double bonferroni() {
    return Math.min(1, p * family.size());
  }

  /**
   * Returns p of Tukey's test for all pairs of means (Tukey 1953; Kramer 1956), exact for
   * independent means of equal error; empty for differences of differences.
   */
  public OptionalDouble tukey() {
    return family.means() < 2 || !Double.isFinite(t)
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            new StudentizedRange(family.means(), df).upper(Math.abs(t) * Math.sqrt(2)));
  }

  /**
   * Returns the difference in units of the pooled standard deviation of the cells (Cohen 1988),
   * which for within levels is d_av (Lakens 2013, Frontiers in Psychology 4).
   *
   * <p>The interval is that of the noncentrality of t, in these units (Steiger and Fouladi 1997):
   * exact for groups measured once, otherwise an approximation that treats the ratio of the
   * standard error to the standard deviation as known.
   */
  public EffectSize d() {
    if (!Double.isFinite(t)) {
      return new EffectSize(Double.NaN, Double.NaN, Double.NaN, confidence);
    }
    NoncentralT.Interval found = new NoncentralT(df).interval(t, confidence);
    double unit = standardError / deviation;
    return new EffectSize(
        difference / deviation, found.low() * unit, found.high() * unit, confidence);
  }

  /**
   * Computes the JZS Bayes factor of a t test. BF01 above 1 is evidence for the null hypothesis.
   */
  private static final class JzsBayesFactor {
    private static final double FIRST = -30;
    private static final double STEP = 0.04;
    private static final double LAST = 4;

    private JzsBayesFactor() {}

    /**
     * Returns BF01 of a t statistic with the prior of Jeffreys, Zellner and Siow: the standardised
     * difference has a Cauchy distribution with the given scale (Rouder, Speckman, Sun, Morey and
     * Iverson 2009, Psychonomic Bulletin and Review 16, equation 1; the scale as in their
     * appendix).
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
}
