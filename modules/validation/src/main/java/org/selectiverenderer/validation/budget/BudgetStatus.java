package org.selectiverenderer.validation.budget;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.State;
import org.selectiverenderer.validation.PolygonBudget;

/**
 * The polygon count of a scene compared with a budget that applies to it.
 *
 * @param group DEF name; empty for the whole scene
 * @param worst the state with the most polygons among those that the budget is for
 */
public record BudgetStatus(PolygonBudget budget, String group, State worst) {
  /**
   * Returns the status; empty where the budget does not apply to the scene or names something
   * misspelt.
   */
  public static Optional<BudgetStatus> of(PolygonBudget budget, EnrichmentPolygonModel model) {
    return BudgetMatch.of(budget, model) instanceof BudgetMatch.Match holds
        ? Optional.of(of(budget, holds))
        : Optional.empty();
  }

  static BudgetStatus of(PolygonBudget budget, BudgetMatch.Match holds) {
    List<State> states = holds.states();
    State worst =
        states.stream()
            .max(Comparator.comparingLong(State::polygons))
            .orElseThrow(); // there is at least one
    return new BudgetStatus(budget, holds.group(), worst);
  }

  /** Returns the number of polygons above the budget; 0 if it is met. */
  public long over() {
    return Math.max(0, worst.polygons() - budget.polygons());
  }

  /** Returns whether the budget is exceeded. */
  public boolean broken() {
    return over() > 0;
  }
}
