package org.selectiverenderer.validation.budget;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.polygon.count.SceneModel;
import org.selectiverenderer.polygon.count.SceneModel.State;
import org.selectiverenderer.validation.Budget;

/**
 * How a scene stands to a budget that is for it.
 *
 * @param group DEF name; empty for the whole scene
 * @param worst the state with the most polygons of those in which the budget holds
 */
public record BudgetStatus(Budget budget, String group, State worst) {
  /** Empty where the budget is not for the scene, or has a slip. */
  public static Optional<BudgetStatus> of(Budget budget, SceneModel model) {
    return BudgetMatch.of(budget, model) instanceof BudgetMatch.Holds holds
        ? Optional.of(of(budget, holds))
        : Optional.empty();
  }

  static BudgetStatus of(Budget budget, BudgetMatch.Holds holds) {
    List<State> states = holds.states();
    State worst =
        states.stream()
            .max(Comparator.comparingLong(State::polygons))
            .orElseThrow(); // one at least
    return new BudgetStatus(budget, holds.group(), worst);
  }

  /** Polygons that are too many; 0 where the budget holds. */
  public long over() {
    return Math.max(0, worst.polygons() - budget.polygons());
  }

  /** Whether there are more polygons than allowed. */
  public boolean broken() {
    return over() > 0;
  }
}
