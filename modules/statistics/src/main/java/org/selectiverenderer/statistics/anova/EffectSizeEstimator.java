package org.selectiverenderer.statistics.anova;

import org.selectiverenderer.statistics.distribution.NoncentralF;
import org.selectiverenderer.statistics.distribution.NoncentralF.Interval;

/**
 * Computes eta squared and omega squared of an effect, with confidence intervals that follow from
 * the interval of the noncentrality l of its F.
 *
 * <p>Partial eta squared: SS / (SS + SS error) (Cohen 1973); bounds l / (l + df1 + df2 + 1)
 * (Steiger 2004; Smithson 2003).
 *
 * <p>Partial omega squared: df1 (F - 1) / (df1 F + df2 + 1), at least 0 (Hays 1963; Olejnik and
 * Algina 2003): an estimate of the same share in the population, without the upward bias of eta
 * squared. Its bounds are those of the population share and hence the same.
 *
 * <p>Generalised eta squared: SS / (SS + all error sums), so that effects of designs with and
 * without within factors can be compared (Olejnik and Algina 2003, Psychological Methods 8; Bakeman
 * 2005); all factors are taken as manipulated, none as measured. Its bounds have no standard form:
 * the same l gives the effect's population sum of squares l MS error, which is divided by the sum
 * of itself and the population's error sum of squares of all scores, N (MS subjects + (levels - 1)
 * MS within). For one-way designs that is Steiger's interval.
 */
final class EffectSizeEstimator {
  private final LinearHypothesis hypothesis;
  private final double f;
  private final double df1;
  private final double df2;
  private final double confidence;
  private final double errorSums;
  private final double populationErrorSum;

  /**
   * Creates the estimator of one effect.
   *
   * @param df1 degrees of freedom of the effect, after any sphericity correction
   * @param df2 degrees of freedom of the error, after any sphericity correction
   * @param confidence confidence level of the intervals; 0.90 matches a test at 0.05, since F tests
   *     of eta squared are one-sided
   */
  EffectSizeEstimator(
      LinearHypothesis hypothesis,
      double f,
      double df1,
      double df2,
      MultivariateLinearModel cells,
      double confidence) {
    this.hypothesis = hypothesis;
    this.f = f;
    this.df1 = df1;
    this.df2 = df2;
    this.confidence = confidence;
    errorSums = cells.error().getTrace();
    populationErrorSum = errorSums / cells.errorDf() * cells.subjects();
  }

  EffectSize partialEta(Interval l) {
    double value = hypothesis.sum() / (hypothesis.sum() + hypothesis.errorSum());
    return new EffectSize(value, share(l.low()), share(l.high()), confidence);
  }

  EffectSize omega(Interval l) {
    double value =
        Math.max(0, hypothesis.df1() * (f - 1) / (hypothesis.df1() * f + hypothesis.df2() + 1));
    return new EffectSize(value, share(l.low()), share(l.high()), confidence);
  }

  private double share(double noncentrality) {
    return noncentrality / (noncentrality + df1 + df2 + 1);
  }

  EffectSize generalisedEta(Interval l) {
    double value = hypothesis.sum() / (hypothesis.sum() + errorSums);
    double ms = hypothesis.errorSum() / hypothesis.df2();
    // The l of a corrected test refers to the corrected degrees of freedom; rescaled, it is the
    // same share of the error.
    double scale = ms * hypothesis.df2() / df2;
    return new EffectSize(
        value,
        l.low() * scale / (l.low() * scale + populationErrorSum),
        l.high() * scale / (l.high() * scale + populationErrorSum),
        confidence);
  }

  /** Returns the confidence interval of the noncentrality of the effect's F. */
  Interval noncentrality() {
    return new NoncentralF(df1, df2).interval(f, confidence);
  }
}
