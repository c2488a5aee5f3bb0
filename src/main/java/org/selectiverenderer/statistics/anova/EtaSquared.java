package org.selectiverenderer.statistics.anova;

import org.selectiverenderer.statistics.distribution.NoncentralF;
import org.selectiverenderer.statistics.distribution.NoncentralF.Interval;

/**
 * Eta squared of an effect, with intervals from those of the noncentrality l of its F.
 *
 * <p>Partial: SS / (SS + SS error) (Cohen 1973); bounds l / (l + df1 + df2 + 1) (Steiger 2004;
 * Smithson 2003).
 *
 * <p>Generalised: SS / (SS + all error sums), so that designs with and without within factors can
 * be compared (Olejnik and Algina 2003, Psychological Methods 8; Bakeman 2005); both factors are
 * manipulated, not measured. Its bounds have no standard form: the same l gives the effect's
 * population sum l MS error, which is set against the population's error sum of all scores, N (MS
 * subjects + (levels - 1) MS within). For one-way designs that is Steiger's interval.
 */
final class EtaSquared {
  private final double confidence;
  private final double errorSums;
  private final double populationErrorSum;

  /**
   * For the effects of one design.
   *
   * @param confidence of the intervals; 0.90 matches a test at 0.05, as eta squared has one side
   *     only
   */
  EtaSquared(CellStatistics cells, double confidence) {
    this.confidence = confidence;
    errorSums = cells.error().getTrace();
    populationErrorSum = errorSums / cells.errorDf() * cells.subjects();
  }

  EffectSize partial(Hypothesis hypothesis, Interval l) {
    double value = hypothesis.sum() / (hypothesis.sum() + hypothesis.errorSum());
    double others = hypothesis.df1() + hypothesis.df2() + 1;
    return new EffectSize(
        value, l.low() / (l.low() + others), l.high() / (l.high() + others), confidence);
  }

  EffectSize generalised(Hypothesis hypothesis, Interval l) {
    double value = hypothesis.sum() / (hypothesis.sum() + errorSums);
    double ms = hypothesis.errorSum() / hypothesis.df2();
    return new EffectSize(
        value,
        l.low() * ms / (l.low() * ms + populationErrorSum),
        l.high() * ms / (l.high() * ms + populationErrorSum),
        confidence);
  }

  /** Of the effect's F; bounds are not numbers when F is none. */
  Interval noncentrality(Hypothesis hypothesis, double f) {
    return Double.isFinite(f)
        ? new NoncentralF(hypothesis.df1(), hypothesis.df2()).interval(f, confidence)
        : new Interval(Double.NaN, Double.NaN);
  }
}
