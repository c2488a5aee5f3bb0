package org.selectiverenderer.validation.budget;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.polygon.count.SceneModel;
import org.selectiverenderer.validation.Budget;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.OutlinedFile;
import org.selectiverenderer.validation.RunCheck;
import org.selectiverenderer.validation.SceneView;

/** Finds budgets that apply to none of the scenes and are therefore never checked. */
final class UnusedBudgetCheck implements RunCheck {
  @Override
  public void check(List<SceneView> scenes, Settings settings, Findings findings) {
    List<Budget> unused = new ArrayList<>(settings.values().budgets());
    for (SceneView scene : scenes) {
      if (unused.isEmpty()) {
        return;
      }
      SceneModel model = OutlinedFile.model(scene);
      // A misspelt name is reported in the scene that has the similar name.
      unused.removeIf(budget -> !(BudgetMatch.of(budget, model) instanceof BudgetMatch.None));
    }
    for (Budget budget : unused) {
      String where = budget.scope().isEmpty() ? "the whole scene" : "the group " + budget.scope();
      String when =
          budget.schemas().isEmpty() ? "" : " with " + String.join(" and ", budget.schemas());
      findings.add(
          BudgetRules.UNUSED_BUDGET,
          Location.of(settings.file()),
          "",
          budget.polygons(),
          where + when);
    }
  }
}
