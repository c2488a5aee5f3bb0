package org.selectiverenderer.statistics.anova;

/**
 * Degrees of freedom corrected for violated sphericity.
 *
 * @param by Greenhouse and Geisser's or Huynh and Feldt's epsilon
 * @param df1 degrees of freedom of the effect, times epsilon
 * @param df2 degrees of freedom of the error, times epsilon
 */
public record CorrectedDegreesOfFreedom(
    SphericityCorrection by, double epsilon, double df1, double df2) {
  static CorrectedDegreesOfFreedom of(
      SphericityCorrection by, double epsilon, double df1, double df2) {
    return new CorrectedDegreesOfFreedom(by, epsilon, df1 * epsilon, df2 * epsilon);
  }
}
