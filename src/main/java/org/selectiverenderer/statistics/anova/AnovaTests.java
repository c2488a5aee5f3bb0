package org.selectiverenderer.statistics.anova;

import java.util.List;
import java.util.Optional;

/**
 * The decisions of an {@link Anova} without its intervals and tables: the same p, in a small part
 * of the time. For simulations, which analyse thousands of studies.
 *
 * @param effects in the order of {@link Anova#effects}
 * @param groups all pairs of levels of the first between factor, over all else; none if it has one
 *     level
 */
public record AnovaTests(List<EffectTest> effects, List<Comparison> groups) {
  /** Keeps copies, so that it stays as it is. */
  public AnovaTests {
    effects = List.copyOf(effects);
    groups = List.copyOf(groups);
  }

  /**
   * Tests the effects of a design.
   *
   * @throws IllegalArgumentException if the design has an {@link Design#obstacle}
   */
  public static AnovaTests of(Design design, AnovaOptions options) {
    Optional<String> obstacle = design.obstacle();
    if (obstacle.isPresent()) {
      throw new IllegalArgumentException(obstacle.get());
    }
    CellStatistics cells = CellStatistics.of(design);
    Factor groups = design.betweenFactors().get(0);
    return new AnovaTests(
        Term.of(design).stream()
            .map(term -> EffectTest.of(term, Hypothesis.of(term, design, cells), cells, options))
            .toList(),
        groups.varies() ? new MeanContrasts(design, cells, options).pairs(groups) : List.of());
  }
}
