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
public record Comparison(
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

  Comparison inFamily(int members, double holm) {
    return new Comparison(
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
    return Double.isFinite(t) ? JzsT.nullFactor(t, df, size, priorScale) : Double.NaN;
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
}
