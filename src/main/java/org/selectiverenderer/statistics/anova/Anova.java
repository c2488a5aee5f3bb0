package org.selectiverenderer.statistics.anova;

import java.util.List;
import java.util.Optional;

/**
 * An analysis of variance and all that stands beside it.
 *
 * @param intercept the mean of all against 0
 * @param effects those of the between factors, then of the within ones and of both
 * @param descriptives of the cells, and over the groups
 * @param bound of TOST, in the measure's units
 */
public record Anova(
    Design design,
    AnovaOptions options,
    Effect intercept,
    List<Effect> effects,
    List<Descriptive> descriptives,
    List<MarginalMean> means,
    List<Comparison> comparisons,
    double bound) {
  /** Keeps copies, so that it stays as it is. */
  public Anova {
    effects = List.copyOf(effects);
    descriptives = List.copyOf(descriptives);
    means = List.copyOf(means);
    comparisons = List.copyOf(comparisons);
  }

  /**
   * Analyses a design. Sums of squares are of type III.
   *
   * @throws IllegalArgumentException if the design has an {@link Design#obstacle}
   */
  public static Anova of(Design design, AnovaOptions options) {
    Optional<String> obstacle = design.obstacle();
    if (obstacle.isPresent()) {
      throw new IllegalArgumentException(obstacle.get());
    }
    CellStatistics cells = CellStatistics.of(design);
    List<Effect> effects =
        Term.of(design).stream().map(term -> Effect.of(term, design, cells, options)).toList();
    MeanContrasts contrasts = new MeanContrasts(design, cells, options);
    return new Anova(
        design,
        options,
        Effect.of(Term.INTERCEPT, design, cells, options),
        effects,
        Descriptive.of(design),
        contrasts.means(),
        contrasts.comparisons(),
        contrasts.bound());
  }

  /** The first effect of that kind, if the design has one. */
  public Optional<Effect> effect(EffectKind kind) {
    return effects.stream().filter(effect -> effect.kind() == kind).findFirst();
  }

  /** What the model leaves of the scores. */
  public Residuals residuals() {
    return Residuals.of(CellStatistics.of(design));
  }
}
