package org.selectiverenderer.statistics.detection;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.linear.RealMatrix;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * The unequal-variance signal detection model, fitted to ratings by maximum likelihood (Dorfman and
 * Alf 1969; Macmillan and Creelman 2005, chapter 3). Standard errors are from the expected
 * information matrix; those of functions of parameters are by the delta method.
 *
 * @param intercept a of the ROC in z coordinates: z of the hit rate where the false-alarm rate is
 *     one half
 * @param slope b of the ROC in z coordinates: the standard deviation of absent objects over that of
 *     present ones
 * @param distance d_a = a sqrt(2 / (1 + b²)): the distance of the means in units of the root mean
 *     square of the two standard deviations; d' where the slope is 1
 * @param area A_z = Phi(d_a / sqrt 2), the area under the fitted ROC
 * @param criteria criteria between the used categories in ascending order, as distances from the
 *     mean of absent objects in units of their standard deviation
 * @param g2 likelihood ratio statistic G² of the model against the observed frequencies
 * @param df degrees of freedom of g2: used categories - 3; with 0 the fit is always perfect
 * @param equal the equal-variance model, with the slope fixed at 1; empty where it has no finite
 *     estimate
 * @param flaw why there is no fit, as a sentence without its full stop; all other values are then
 *     NaN
 */
public record UnequalVarianceFit(
    Estimate intercept,
    Estimate slope,
    Estimate distance,
    Estimate area,
    List<Estimate> criteria,
    double g2,
    int df,
    Optional<EqualVariance> equal,
    Optional<String> flaw) {
  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

  /** With fewer used categories, the slope cannot be estimated. */
  private static final int LEAST_CATEGORIES = 3;

  /** A parameter or a function of parameters, and its standard error. */
  public record Estimate(double value, double standardError) {
    private static final Estimate NONE = new Estimate(Double.NaN, Double.NaN);
  }

  /**
   * The equal-variance model.
   *
   * @param dPrime d', the distance of the means
   * @param g2 likelihood ratio statistic, with one more degree of freedom than that of the
   *     unequal-variance model
   */
  public record EqualVariance(Estimate dPrime, double g2) {}

  /** Makes defensive copies, so that the record is immutable. */
  public UnequalVarianceFit {
    criteria = List.copyOf(criteria);
  }

  /** Fits the model to ratings. */
  public static UnequalVarianceFit of(RatingCounts all) {
    RatingCounts used = all.used();
    if (used.noiseTotal() == 0 || used.signalTotal() == 0) {
      return none(EmpiricalRoc.of(all).flaw().orElseThrow());
    }
    if (used.categories() < LEAST_CATEGORIES) {
      return none("fewer than %d of the ratings were used".formatted(LEAST_CATEGORIES));
    }
    RatingLikelihood free = new RatingLikelihood(used, false);
    Optional<MaximumLikelihoodEstimate> found = MaximumLikelihoodEstimate.of(free);
    if (found.isEmpty()) {
      return none("the likelihood grows without a finite maximum, as with few or extreme ratings");
    }
    return of(found.get(), free.saturatedLog(), used.categories() - LEAST_CATEGORIES, equal(used));
  }

  private static Optional<EqualVariance> equal(RatingCounts used) {
    RatingLikelihood fixed = new RatingLikelihood(used, true);
    return MaximumLikelihoodEstimate.of(fixed)
        .map(
            maximum ->
                new EqualVariance(estimate(maximum, 0), g2(fixed.saturatedLog(), maximum.log())));
  }

  private static UnequalVarianceFit of(
      MaximumLikelihoodEstimate maximum, double saturated, int df, Optional<EqualVariance> equal) {
    double a = maximum.at()[0];
    double b = maximum.at()[1];
    double spread = Math.sqrt(1 + b * b);
    // partial derivatives of a / spread by a and b
    double byA = 1 / spread;
    double byB = -a * b / (spread * spread * spread);
    double error = Math.sqrt(variance(maximum.covariance(), byA, byB));
    double z = a / spread;
    return new UnequalVarianceFit(
        estimate(maximum, 0),
        estimate(maximum, 1),
        new Estimate(Math.sqrt(2) * z, Math.sqrt(2) * error),
        new Estimate(NORMAL.cumulativeProbability(z), NORMAL.density(z) * error),
        IntStream.range(RatingLikelihood.CRITERIA, maximum.at().length)
            .mapToObj(i -> estimate(maximum, i))
            .toList(),
        g2(saturated, maximum.log()),
        df,
        equal,
        Optional.empty());
  }

  private static double variance(RealMatrix covariance, double byA, double byB) {
    return byA * byA * covariance.getEntry(0, 0)
        + 2 * byA * byB * covariance.getEntry(0, 1)
        + byB * byB * covariance.getEntry(1, 1);
  }

  private static Estimate estimate(MaximumLikelihoodEstimate maximum, int parameter) {
    return new Estimate(
        maximum.at()[parameter], Math.sqrt(maximum.covariance().getEntry(parameter, parameter)));
  }

  private static double g2(double saturated, double fitted) {
    return Math.max(0, 2 * (saturated - fitted));
  }

  private static UnequalVarianceFit none(String reason) {
    return new UnequalVarianceFit(
        Estimate.NONE,
        Estimate.NONE,
        Estimate.NONE,
        Estimate.NONE,
        List.of(),
        Double.NaN,
        0,
        Optional.empty(),
        Optional.of(reason));
  }

  /**
   * Returns p of g2, which is small where the model does not fit; NaN without degrees of freedom.
   */
  public double fitP() {
    return df > 0 ? TailProbabilities.chiSquared(g2, df) : Double.NaN;
  }

  /**
   * Returns the likelihood ratio statistic of the test of the slope against 1, with one degree of
   * freedom.
   */
  public double slopeG2() {
    return equal.map(fit -> Math.max(0, fit.g2() - g2)).orElse(Double.NaN);
  }

  /** Returns p of {@link #slopeG2}, which is small where the standard deviations differ. */
  public double slopeP() {
    double ratio = slopeG2();
    return Double.isNaN(ratio) ? ratio : TailProbabilities.chiSquared(ratio, 1);
  }

  /** Returns the fitted hit rate at a false-alarm rate between 0 and 1. */
  public double hitRate(double falseAlarmRate) {
    return NORMAL.cumulativeProbability(
        intercept.value() + slope.value() * NORMAL.inverseCumulativeProbability(falseAlarmRate));
  }
}
