package org.selectiverenderer.statistics.anova;

import java.util.List;
import java.util.Optional;

/**
 * An analysis of variance: tests of effects, descriptive statistics, estimated marginal means, and
 * comparisons.
 *
 * @param intercept the test of the grand mean against 0
 * @param effects the effects of the between factors, then those of the within factors and their
 *     interactions
 * @param descriptives means and standard deviations of the cells, and over all groups
 * @param bound the equivalence bound of TOST, in the measure's units
 */
public record Anova(
    FactorialDesign design,
    AnovaOptions options,
    Effect intercept,
    List<Effect> effects,
    List<CellDescriptives> descriptives,
    List<MarginalMean> means,
    List<PairwiseComparison> comparisons,
    double bound) {
  /** Makes defensive copies, so that the record is immutable. */
  public Anova {
    effects = List.copyOf(effects);
    descriptives = List.copyOf(descriptives);
    means = List.copyOf(means);
    comparisons = List.copyOf(comparisons);
  }

  /**
   * Analyses a design with type III sums of squares.
   *
   * @throws IllegalArgumentException if the design has an {@link FactorialDesign#obstacle}
   */
  public static Anova of(FactorialDesign design, AnovaOptions options) {
    Optional<String> obstacle = design.obstacle();
    if (obstacle.isPresent()) {
      throw new IllegalArgumentException(obstacle.get());
    }
    MultivariateLinearModel cells = MultivariateLinearModel.of(design);
    List<Effect> effects =
        Term.of(design).stream().map(term -> Effect.of(term, design, cells, options)).toList();
    ContrastEstimator contrasts = new ContrastEstimator(design, cells, options);
    return new Anova(
        design,
        options,
        Effect.of(Term.INTERCEPT, design, cells, options),
        effects,
        CellDescriptives.of(design),
        contrasts.means(),
        contrasts.comparisons(),
        contrasts.bound());
  }

  /** Returns the first effect of that kind, if the design has one. */
  public Optional<Effect> effect(EffectKind kind) {
    return effects.stream().filter(effect -> effect.kind() == kind).findFirst();
  }

  /** Returns the residuals of the model. */
  public Residuals residuals() {
    return Residuals.of(MultivariateLinearModel.of(design));
  }
}
