package org.selectiverenderer.statistics.anova;

import org.selectiverenderer.statistics.distribution.NoncentralF;

/**
 * The equivalence test of an effect: the hypothesis that its partial eta squared is at least the
 * bound is rejected when F is small enough, p = P(F &le; f) with noncentrality bound / (1 - bound)
 * (df1 + df2 + 1) (Campbell and Lakens 2021, British Journal of Mathematical and Statistical
 * Psychology 74; Wellek 2010, Testing Statistical Hypotheses of Equivalence and Noninferiority,
 * 9.2).
 *
 * @param bound equivalence bound of the partial eta squared
 * @param p below alpha, the effect is smaller than the bound
 */
public record OmnibusEquivalence(double bound, double p) {
  static OmnibusEquivalence of(double f, double df1, double df2, double bound) {
    double noncentrality = bound / (1 - bound) * (df1 + df2 + 1);
    double p =
        Double.isFinite(f) ? new NoncentralF(df1, df2).cumulative(f, noncentrality) : Double.NaN;
    return new OmnibusEquivalence(bound, p);
  }
}
