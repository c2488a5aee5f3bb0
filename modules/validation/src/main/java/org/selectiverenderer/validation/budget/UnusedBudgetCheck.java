package org.selectiverenderer.validation.budget;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CrossSceneCheck;
import org.selectiverenderer.validation.FileOutlineAdapter;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.SceneContext;

/** Finds budgets that apply to none of the scenes and are therefore never checked. */
final class UnusedBudgetCheck implements CrossSceneCheck {
  @Override
  public void check(List<SceneContext> scenes, Settings settings, FindingCollector findings) {
    List<CostBudget> unused = new ArrayList<>(settings.values().budgets());
    for (SceneContext scene : scenes) {
      if (unused.isEmpty()) {
        return;
      }
      EnrichmentPolygonModel model = FileOutlineAdapter.model(scene);
      // A misspelt name is reported in the scene that has the similar name.
      unused.removeAll(
          settings.values().budgets(scene.main().file().path()).stream()
              .filter(budget -> !(BudgetMatch.of(budget, model) instanceof BudgetMatch.NoMatch))
              .toList());
    }
    for (CostBudget budget : unused) {
      String where = budget.scope().isEmpty() ? "the whole scene" : "the group " + budget.scope();
      String when =
          budget.schemas().isEmpty() ? "" : " with " + String.join(" and ", budget.schemas());
      findings.add(
          BudgetRules.UNUSED_BUDGET,
          SourceLocation.of(settings.file()),
          "",
          budget.limits().entrySet().stream()
              .map(
                  limit -> DecimalFormatter.grouped(limit.getValue()) + " " + limit.getKey().unit())
              .collect(Collectors.joining(", ")),
          where + when + (budget.file().isEmpty() ? "" : " of " + budget.file()));
    }
  }
}
