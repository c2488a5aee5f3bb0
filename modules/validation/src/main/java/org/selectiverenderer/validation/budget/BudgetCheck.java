package org.selectiverenderer.validation.budget;

import java.util.List;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CostKind;
import org.selectiverenderer.validation.FileOutlineAdapter;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneContext;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Checks the costs of parts of a scene against their budgets. */
final class BudgetCheck implements SceneCheck {
  @Override
  public void check(SceneContext view, FindingCollector findings) {
    List<CostBudget> budgets = view.settings().budgets(view.main().file().path());
    if (!budgets.isEmpty()) {
      EnrichmentPolygonModel model = FileOutlineAdapter.model(view);
      for (CostBudget budget : budgets) {
        BudgetMatch fit = BudgetMatch.of(budget, model);
        if (fit instanceof BudgetMatch.Match holds) {
          budget.limits().keySet().forEach(kind -> worst(view, budget, kind, holds, findings));
        } else if (fit instanceof BudgetMatch.NearMiss slip) {
          Object[] words = {slip.kind(), slip.name(), slip.near()};
          report(view, BudgetRules.NO_SUCH_BUDGET, slip.group(), findings, words);
        } // A budget without a match may be for another scene: UnusedBudgetCheck.
      }
    }
  }

  private static void worst(
      SceneContext view,
      CostBudget budget,
      CostKind kind,
      BudgetMatch.Match holds,
      FindingCollector findings) {
    BudgetStatus status = BudgetStatus.of(budget, kind, holds);
    if (status.broken()) {
      report(
          view,
          BudgetRules.OVER_BUDGET,
          status.group(),
          findings,
          status.group().isEmpty() ? "the scene" : status.group(),
          DecimalFormatter.grouped(status.cost()),
          kind.unit(),
          in(status.worst().schemas()),
          DecimalFormatter.grouped(status.over()),
          DecimalFormatter.grouped(status.limit()));
    }
  }

  private static String in(List<String> schemas) {
    return schemas.isEmpty() ? "outside all areas" : "with " + String.join(" and ", schemas);
  }

  private static void report(
      SceneContext view, Rule rule, String group, FindingCollector findings, Object... words) {
    ParsedNode node = view.main().scene().named().get(group);
    if (node == null) {
      findings.add(rule, SourceLocation.of(view.main().file().name()), "", words);
    } else {
      findings.add(rule, node, words);
    }
  }
}
