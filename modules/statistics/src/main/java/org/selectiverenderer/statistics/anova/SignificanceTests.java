package org.selectiverenderer.statistics.anova;

import java.util.List;
import java.util.Optional;

/**
 * The p values of an {@link Anova} without its intervals and tables, computed in a fraction of the
 * time: for simulations, which analyse thousands of studies.
 *
 * @param effects F tests of the effects, in the order of {@link Anova#effects}
 * @param groups comparisons of all pairs of levels of the first between factor, averaged over the
 *     other factors; empty if that factor has one level
 */
public record SignificanceTests(List<FTestResult> effects, List<PairwiseComparison> groups) {
  /** Makes defensive copies, so that the record is immutable. */
  public SignificanceTests {
    effects = List.copyOf(effects);
    groups = List.copyOf(groups);
  }

  /**
   * Tests the effects of a design.
   *
   * @throws IllegalArgumentException if the design has an {@link FactorialDesign#obstacle}
   */
  public static SignificanceTests of(FactorialDesign design, AnovaOptions options) {
    Optional<String> obstacle = design.obstacle();
    if (obstacle.isPresent()) {
      throw new IllegalArgumentException(obstacle.get());
    }
    MultivariateLinearModel cells = MultivariateLinearModel.of(design);
    Factor groups = design.betweenFactors().get(0);
    return new SignificanceTests(
        Term.of(design).stream()
            .map(
                term ->
                    FTestResult.of(term, LinearHypothesis.of(term, design, cells), cells, options))
            .toList(),
        groups.varies() ? new ContrastEstimator(design, cells, options).pairs(groups) : List.of());
  }
}
