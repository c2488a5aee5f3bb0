package org.selectiverenderer.validation.budget;

import java.util.List;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.polygon.count.SceneModel;
import org.selectiverenderer.validation.Budget;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.OutlinedFile;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Checks the polygons of parts of a scene against their budgets. */
final class BudgetCheck implements SceneCheck {
  @Override
  public void check(SceneView view, Findings findings) {
    if (!view.settings().budgets().isEmpty()) {
      SceneModel model = OutlinedFile.model(view);
      for (Budget budget : view.settings().budgets()) {
        BudgetMatch fit = BudgetMatch.of(budget, model);
        if (fit instanceof BudgetMatch.Holds holds) {
          worst(view, budget, holds, findings);
        } else if (fit instanceof BudgetMatch.Slip slip) {
          Object[] words = {slip.kind(), slip.name(), slip.near()};
          report(view, BudgetRules.NO_SUCH_BUDGET, slip.group(), findings, words);
        } // A budget without a match may be for another scene: UnusedBudgetCheck.
      }
    }
  }

  private static void worst(
      SceneView view, Budget budget, BudgetMatch.Holds holds, Findings findings) {
    BudgetStatus status = BudgetStatus.of(budget, holds);
    if (status.broken()) {
      report(
          view,
          BudgetRules.OVER_BUDGET,
          status.group(),
          findings,
          status.group().isEmpty() ? "the scene" : status.group(),
          status.worst().polygons(),
          in(status.worst().schemas()),
          status.over(),
          budget.polygons());
    }
  }

  private static String in(List<String> schemas) {
    return schemas.isEmpty() ? "outside all areas" : "with " + String.join(" and ", schemas);
  }

  private static void report(
      SceneView view, Rule rule, String group, Findings findings, Object... words) {
    ParsedNode node = view.main().scene().named().get(group);
    if (node == null) {
      findings.add(rule, Location.of(view.main().file().name()), "", words);
    } else {
      findings.add(rule, node, words);
    }
  }
}
