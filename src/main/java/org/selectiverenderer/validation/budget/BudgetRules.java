package org.selectiverenderer.validation.budget;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** SR5xx: polygon budgets. */
public final class BudgetRules {
  static final Rule OVER_BUDGET =
      Rule.error(
              "SR501",
              "{scope} has {polygons} polygons {state}, {over} more than its budget of {budget}")
          .because(
              """
              The settings allow a part of the scene so many polygons. Without schemas the budget \
              is held against the worst state that a viewer can bring about by entering and \
              leaving areas; with schemas against that state alone.""")
          .bad(example("Office", 170000, 180500))
          .good(example("Office", 190000, 180500))
          .see("thesis 6.2, Tables 3-5");

  static final Rule NO_SUCH_BUDGET =
      Rule.warning("SR502", "a budget is for the {kind} {name}, but the scene has {near}")
          .because(
              """
              A budget of a group that a scene does not have does not concern that scene. This \
              one has nearly the same name, so that the settings probably have a slip, and the \
              budget is not checked.""")
          .bad(example("Ofice", 190000, 180500))
          .good(example("Office", 190000, 180500))
          .see("thesis 6.2");

  private BudgetRules() {}

  private static String example(String scope, int budget, int polygons) {
    return """
        <!-- with --config: {"budgets": [{"scope": "%s", "polygons": %d}]} -->
        <Group DEF='Office'>
          <!-- %d polygons at worst -->
        </Group>"""
        .formatted(scope, budget, polygons);
  }

  public static RuleGroup group() {
    return new RuleGroup(
        "Budget", List.of(OVER_BUDGET, NO_SUCH_BUDGET), List.of(), List.of(new BudgetCheck()));
  }
}
