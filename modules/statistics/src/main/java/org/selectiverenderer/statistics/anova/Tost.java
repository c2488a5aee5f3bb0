package org.selectiverenderer.statistics.anova;

import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * Two one-sided tests of equivalence (Schuirmann 1987, Journal of Pharmacokinetics and
 * Biopharmaceutics 15; Lakens 2017, Social Psychological and Personality Science 8): a difference
 * is shown to lie within bounds when it is both above the lower and below the upper one.
 *
 * @param bound equivalence bound: the difference is tested to lie between -bound and bound, in the
 *     measure's units
 * @param lowerT t against the lower bound
 * @param upperT t against the upper bound
 * @param p the larger p of the two tests
 */
public record Tost(double bound, double lowerT, double upperT, double p) {
  static Tost of(double difference, double standardError, double df, double bound) {
    double lower = (difference + bound) / standardError;
    double upper = (difference - bound) / standardError;
    return new Tost(
        bound,
        lower,
        upper,
        Math.max(TailProbabilities.t(lower, df), TailProbabilities.t(-upper, df)));
  }
}
