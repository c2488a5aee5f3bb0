package org.selectiverenderer.validation.budget;

import java.util.List;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;

/** Declares the rules SR500 to SR599, about budgets. */
public final class BudgetRules {
  static final Rule OVER_BUDGET =
      Rule.error(
              "SR501",
              "{scope} has {count} {unit} {state}, which is {over} more than "
                  + "its budget of {budget}")
          .because(
              """
              The settings limit what a part of the scene costs: its polygons, the bytes of its \
              textures (decoded, with mip maps, each picture once) or its draw calls (the \
              shapes that are drawn). Without schemas the \
              budget is compared with the worst state that a viewer can cause by entering \
              and leaving areas; with schemas, with the state of these schemas alone.""")
          .bad(example("Office", 170000, 180500))
          .good(example("Office", 190000, 180500))
          .see("thesis 6.2, Tables 3-5");

  static final Rule NO_SUCH_BUDGET =
      Rule.warning("SR502", "a budget is for the {kind} {name}, but the scene has {near}")
          .because(
              """
              A budget of a group or of schemas that a scene does not have is ignored for \
              that scene. The scene has a very similar name, so the settings probably have a \
              typing error. The budget is not checked.""")
          .bad(example("Ofice", 190000, 180500))
          .good(example("Office", 190000, 180500))
          .see("thesis 6.2");

  static final Rule UNUSED_BUDGET =
      Rule.warning("SR503", "the budget of {limits} for {what} fits no scene of this run")
          .because(
              """
              No scene has such a group, or such schemas that can be active together, so the \
              budget never fails. If you check only some of the scenes, add --ignore SR503.""")
          .bad(example("Kitchen", 190000, 180500))
          .good(example("Office", 190000, 180500))
          .see("docs/validate.md");

  private BudgetRules() {}

  private static String example(String scope, int budget, int polygons) {
    return """
        <!-- with --config: {"budgets": [{"scope": "%s", "polygons": %d}]} -->
        <Group DEF='Office'>
          <!-- %d polygons at worst -->
        </Group>"""
        .formatted(scope, budget, polygons);
  }

  /** The rules and their check. */
  public static RuleGroup group() {
    return new RuleGroup(
        "Budget",
        List.of(OVER_BUDGET, NO_SUCH_BUDGET, UNUSED_BUDGET),
        List.of(),
        List.of(new BudgetCheck()),
        List.of(new UnusedBudgetCheck()));
  }
}
