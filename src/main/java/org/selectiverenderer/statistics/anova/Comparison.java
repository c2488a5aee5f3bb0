package org.selectiverenderer.statistics.anova;

import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.statistics.distribution.NoncentralT;
import org.selectiverenderer.statistics.distribution.StudentizedRange;

/**
 * Two levels of a factor compared, with the design's pooled error.
 *
 * @param factor whose levels are compared; {@code within x between} for differences of differences
 * @param at the level of another factor at which they are; empty: over all, with equal weight
 * @param difference first less second, in the measure's units
 * @param low of the confidence interval of the difference, not adjusted
 * @param p not adjusted
 * @param family that it is one of, with p after Holm in it
 * @param deviation pooled standard deviation of the scores of a cell
 * @param confidence of the intervals
 * @param size effective number of subjects: n1 n2 / (n1 + n2) for two groups, the number of pairs
 *     for pairs
 * @param priorScale of the Bayes factor
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
   * The comparisons that are held to one level of error together.
   *
   * @param size how many
   * @param means how many levels they are all pairs of; 0 if they are no such pairs
   * @param holm p after Holm (1979)
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

  /** BF01 of Jeffreys, Zellner and Siow; not a number where t is none. */
  public double bayesFactor() {
    return Double.isFinite(t) ? JzsT.nullFactor(t, df, size, priorScale) : Double.NaN;
  }

  /** p after Holm. */
  public double holm() {
    return family.holm();
  }

  /** p times the family's size, at most 1. */
  public double bonferroni() {
    return Math.min(1, p * family.size());
  }

  /**
   * p of Tukey's test for all pairs of means (Tukey 1953; Kramer 1956), exact for independent means
   * of equal error; empty for differences of differences.
   */
  public OptionalDouble tukey() {
    return family.means() < 2 || !Double.isFinite(t)
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            new StudentizedRange(family.means(), df).upper(Math.abs(t) * Math.sqrt(2)));
  }

  /**
   * The difference in pooled standard deviations of the cells (Cohen 1988), which for within levels
   * is d_av (Lakens 2013, Frontiers in Psychology 4).
   *
   * <p>The interval is that of the noncentrality of t, in these units (Steiger and Fouladi 1997):
   * exact for groups measured once, otherwise an approximation that takes the ratio of the standard
   * error to the standard deviation for known.
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
