package org.selectiverenderer.statistics.bayes;

import java.util.List;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.Term;

/**
 * What the data say for the null hypothesis about an effect.
 *
 * @param beside all effects that do not contain it against the same and the effect; what reports
 *     call BF01
 * @param alone those that it contains (an interaction's main effects) against the same and the
 *     effect: where other effects are large, this takes them for error
 * @param robustness {@code beside} with other widths of the prior, in ascending order
 */
public record EffectEvidence(Term term, Ratio beside, Ratio alone, List<Point> robustness) {
  /**
   * A Bayes factor.
   *
   * @param bf01 above 1 speaks for no effect; not a number where there is none
   * @param error of bf01, a share of it: 0 where the integral is not by Monte Carlo
   */
  public record Ratio(double bf01, double error) {}

  /**
   * A Bayes factor with one width of the prior.
   *
   * @param scale of the factors' effects
   */
  public record Point(double scale, double bf01) {}

  /** Keeps copies, so that it stays as it is. */
  public EffectEvidence {
    robustness = List.copyOf(robustness);
  }

  /** The effect that it is about, of the analysis that it comes from. */
  public Effect of(Anova anova) {
    return anova.effects().stream()
        .filter(effect -> effect.term().equals(term))
        .findFirst()
        .orElseThrow();
  }

  /** Of all effects that do not contain it against the same and the effect. */
  public double bf01() {
    return beside.bf01();
  }

  /** Of {@link #bf01}. */
  public double error() {
    return beside.error();
  }
}
