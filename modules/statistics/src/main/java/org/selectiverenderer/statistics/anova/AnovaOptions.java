package org.selectiverenderer.statistics.anova;

/**
 * The options of an analysis of variance. Every report states them.
 *
 * @param alpha significance level of the tests of difference and of equivalence
 * @param confidence confidence level of intervals of means and differences, 0 to 1
 * @param etaConfidence confidence level of intervals of eta squared, 0 to 1
 * @param differenceBound equivalence bound of TOST, in standard deviations or, if {@code rawBound},
 *     in the measure's own units
 * @param rawBound whether the bound is in the measure's units
 * @param etaBound smallest partial eta squared that would matter
 * @param priorScale scale of the Cauchy prior of the JZS Bayes factor of a comparison
 * @param sphericity how degrees of freedom are corrected where sphericity is violated
 * @param prior prior of the Bayes factors of effects
 */
public record AnovaOptions(
    double alpha,
    double confidence,
    double etaConfidence,
    double differenceBound,
    boolean rawBound,
    double etaBound,
    double priorScale,
    SphericityCorrection sphericity,
    EffectPrior prior) {
  /**
   * Half a standard deviation and a partial eta squared of 0.06 are the middle of Cohen's 1988
   * conventions; the priors' scales are those of Morey and Rouder's BayesFactor.
   */
  public static final AnovaOptions DEFAULT =
      new AnovaOptions(
          0.05,
          0.95,
          0.90,
          0.5,
          false,
          0.06,
          Math.sqrt(2) / 2,
          SphericityCorrection.AUTO,
          EffectPrior.MEDIUM);

  /** Returns the options with TOST's equivalence bound in the measure's own units. */
  public AnovaOptions withRawBound(double bound) {
    return with(bound, true, etaBound, sphericity, prior);
  }

  /** Returns the options with TOST's equivalence bound in standard deviations. */
  public AnovaOptions withStandardBound(double bound) {
    return with(bound, false, etaBound, sphericity, prior);
  }

  /** Returns the options with another equivalence bound of partial eta squared. */
  public AnovaOptions withEtaBound(double bound) {
    return with(differenceBound, rawBound, bound, sphericity, prior);
  }

  /** Returns the options with another correction for violated sphericity. */
  public AnovaOptions withSphericity(SphericityCorrection choice) {
    return with(differenceBound, rawBound, etaBound, choice, prior);
  }

  /** Returns the options with another prior of the Bayes factors of effects. */
  public AnovaOptions withPrior(EffectPrior effects) {
    return with(differenceBound, rawBound, etaBound, sphericity, effects);
  }

  private AnovaOptions with(
      double bound, boolean raw, double eta, SphericityCorrection choice, EffectPrior effects) {
    return new AnovaOptions(
        alpha, confidence, etaConfidence, bound, raw, eta, priorScale, choice, effects);
  }
}
