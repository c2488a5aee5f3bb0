package org.selectiverenderer.statistics.bayes;

import java.util.List;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.Term;

/**
 * The Bayes factors of an effect: the evidence of the data for its absence.
 *
 * @param beside the model of all effects that do not contain this one, against that model with this
 *     effect; reports call it BF01
 * @param alone the model of the effects that this one contains (an interaction's main effects)
 *     only, against that model with this effect; other effects count as error here
 * @param robustness {@code beside} with other scales of the prior, in ascending order
 */
public record EffectBayesFactors(Term term, Ratio beside, Ratio alone, List<Point> robustness) {
  /**
   * A Bayes factor.
   *
   * @param bf01 above 1 is evidence for the absence of the effect; NaN where it is not defined
   * @param error relative standard error of bf01; 0 where no Monte Carlo integration is needed
   */
  public record Ratio(double bf01, double error) {}

  /**
   * A Bayes factor with one scale of the prior.
   *
   * @param scale prior scale r of the fixed effects
   */
  public record Point(double scale, double bf01) {}

  /** Makes defensive copies, so that the record is immutable. */
  public EffectBayesFactors {
    robustness = List.copyOf(robustness);
  }

  /** Returns the effect that these Bayes factors are about, from their analysis. */
  public Effect of(Anova anova) {
    return anova.effects().stream()
        .filter(effect -> effect.term().equals(term))
        .findFirst()
        .orElseThrow();
  }

  /** Returns the Bayes factor {@link #beside}. */
  public double bf01() {
    return beside.bf01();
  }

  /** Returns the relative standard error of {@link #bf01}. */
  public double error() {
    return beside.error();
  }
}
