package org.selectiverenderer.validation.budget;

import java.util.List;
import org.selectiverenderer.validation.RuleGroup;

/** SR5xx: polygon budgets. */
public final class BudgetRules {
  private BudgetRules() {}

  public static RuleGroup group() {
    return new RuleGroup("Budget", List.of(), List.of(), List.of());
  }
}
