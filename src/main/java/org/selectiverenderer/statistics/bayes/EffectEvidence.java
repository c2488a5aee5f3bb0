package org.selectiverenderer.statistics.bayes;

import java.util.List;
import org.selectiverenderer.statistics.anova.Term;

/**
 * What the data say for the null hypothesis about an effect.
 *
 * @param bf01 above 1 speaks for no effect; not a number where there is none
 * @param error of bf01, a share of it: 0 where the integral is not by Monte Carlo
 * @param robustness the same with other widths of the prior, in ascending order
 */
public record EffectEvidence(Term term, double bf01, double error, List<Point> robustness) {
  /**
   * A Bayes factor with one width of the prior.
   *
   * @param scale of the factors' effects
   */
  public record Point(double scale, double bf01) {}

  public EffectEvidence {
    robustness = List.copyOf(robustness);
  }
}
