package org.selectiverenderer.validation.budget;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.validation.CrossSceneCheck;
import org.selectiverenderer.validation.FileOutlineAdapter;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.PolygonBudget;
import org.selectiverenderer.validation.SceneContext;

/** Finds budgets that apply to none of the scenes and are therefore never checked. */
final class UnusedBudgetCheck implements CrossSceneCheck {
  @Override
  public void check(List<SceneContext> scenes, Settings settings, FindingCollector findings) {
    List<PolygonBudget> unused = new ArrayList<>(settings.values().budgets());
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
    for (PolygonBudget budget : unused) {
      String where = budget.scope().isEmpty() ? "the whole scene" : "the group " + budget.scope();
      String when =
          budget.schemas().isEmpty() ? "" : " with " + String.join(" and ", budget.schemas());
      findings.add(
          BudgetRules.UNUSED_BUDGET,
          SourceLocation.of(settings.file()),
          "",
          DecimalFormatter.grouped(budget.polygons()),
          where + when + (budget.file().isEmpty() ? "" : " of " + budget.file()));
    }
  }
}
