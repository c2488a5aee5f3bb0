package org.selectiverenderer.validation.budget;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.State;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CostKind;

/**
 * What a scene costs, compared with a limit of a budget that applies to it.
 *
 * @param kind what the limit is of; the budget has one
 * @param group DEF name; empty for the whole scene
 * @param worst the state that costs the most among those that the budget is for
 */
public record BudgetStatus(CostBudget budget, CostKind kind, String group, State worst) {
  /**
   * Returns the status; empty where the budget does not apply to the scene, names something
   * misspelt, or has no such limit.
   */
  public static Optional<BudgetStatus> of(
      CostBudget budget, CostKind kind, EnrichmentPolygonModel model) {
    return budget.limit(kind).isPresent()
            && BudgetMatch.of(budget, model) instanceof BudgetMatch.Match holds
        ? Optional.of(of(budget, kind, holds))
        : Optional.empty();
  }

  static BudgetStatus of(CostBudget budget, CostKind kind, BudgetMatch.Match holds) {
    List<State> states = holds.states();
    State worst =
        states.stream()
            .max(Comparator.comparingLong(kind::of))
            .orElseThrow(); // there is at least one
    return new BudgetStatus(budget, kind, holds.group(), worst);
  }

  /** Returns the greatest number allowed. */
  public long limit() {
    return budget.limit(kind).orElseThrow();
  }

  /** Returns the number in the worst state. */
  public long cost() {
    return kind.of(worst);
  }

  /** Returns how much the cost is above the budget; 0 if it is met. */
  public long over() {
    return Math.max(0, cost() - limit());
  }

  /** Returns whether the budget is exceeded. */
  public boolean broken() {
    return over() > 0;
  }
}
