package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * An analysis of variance and all that stands beside it.
 *
 * @param intercept the mean of all against 0
 * @param effects between, within and interaction, those that the design has
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
    List<Effect> effects = new ArrayList<>();
    for (EffectKind kind : EffectKind.values()) {
      boolean tested =
          kind != EffectKind.INTERCEPT
              && (!kind.ofGroups() || design.between().varies())
              && (!kind.ofContrasts() || design.within().varies());
      if (tested) {
        effects.add(Effect.of(kind, name(kind, design), cells, options));
      }
    }
    MeanContrasts contrasts = new MeanContrasts(design, cells, options);
    return new Anova(
        design,
        options,
        Effect.of(EffectKind.INTERCEPT, "intercept", cells, options),
        effects,
        Descriptive.of(design),
        contrasts.means(),
        contrasts.comparisons(),
        contrasts.bound());
  }

  private static String name(EffectKind kind, Design design) {
    return switch (kind) {
      case INTERCEPT -> "intercept";
      case BETWEEN -> design.between().name();
      case WITHIN -> design.within().name();
      case INTERACTION -> design.within().name() + " x " + design.between().name();
    };
  }

  /** The effect of that kind, if the design has it. */
  public Optional<Effect> effect(EffectKind kind) {
    return effects.stream().filter(effect -> effect.kind() == kind).findFirst();
  }
}
