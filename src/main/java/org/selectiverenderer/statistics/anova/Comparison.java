package org.selectiverenderer.statistics.anova;

import java.util.Optional;

/**
 * Two levels of a factor compared, with the design's pooled error.
 *
 * @param factor whose levels are compared; {@code within x between} for differences of differences
 * @param at the level of the other factor at which they are; empty: over all, with equal weight
 * @param difference first less second, in the measure's units
 * @param low of the confidence interval of the difference, not adjusted
 * @param p not adjusted
 * @param holm p after Holm, within the comparisons of this factor at this level
 * @param d the difference in pooled standard deviations of the cells (Cohen 1988), which for within
 *     levels is d_av (Lakens 2013, Frontiers in Psychology 4)
 * @param bayesFactor BF01, JZS
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
    double holm,
    double d,
    Tost tost,
    double bayesFactor) {
  Comparison withHolm(double adjusted) {
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
        adjusted,
        d,
        tost,
        bayesFactor);
  }
}
