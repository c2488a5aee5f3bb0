package org.selectiverenderer.validation.budget;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.polygon.statistics.SceneModel;
import org.selectiverenderer.polygon.statistics.SceneModel.State;
import org.selectiverenderer.schema.SchemaNames;
import org.selectiverenderer.validation.Budget;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.OutlinedFile;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneView;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.ParsedNode;

/**
 * Polygons of parts of a scene against their budgets. A group is found by its DEF name, else by the
 * only one that differs in letter case; a scene without it is not concerned.
 */
final class BudgetCheck implements SceneCheck {
  @Override
  public void check(SceneView view, Findings findings) {
    if (!view.settings().budgets().isEmpty()) {
      SceneModel model = OutlinedFile.model(view);
      Scene scene = new Scene(view, model, findings);
      view.settings().budgets().forEach(scene::check);
    }
  }

  /** One scene and its budgets. */
  private record Scene(SceneView view, SceneModel model, Findings findings) {
    void check(Budget budget) {
      String wanted = budget.scope();
      Optional<String> group = wanted.isEmpty() ? Optional.of("") : group(wanted);
      if (group.isPresent()) {
        check(budget, group.get());
      } else {
        SchemaNames.probablyMeant(wanted, model.groups())
            .ifPresent(near -> report(BudgetRules.NO_SUCH_BUDGET, near, "group", wanted, near));
      }
    }

    private void check(Budget budget, String group) {
      Set<String> wanted = new HashSet<>(budget.schemas());
      for (String schema : budget.schemas()) {
        Optional<String> near = schemas().contains(schema) ? Optional.empty() : near(schema);
        if (near.isPresent()) {
          report(BudgetRules.NO_SUCH_BUDGET, group, "schema", schema, near.get());
          return;
        }
      }
      // What no area activates on entering holds where the viewer is in none.
      wanted.retainAll(entered());
      List<State> states =
          model.states(group).stream()
              .filter(s -> budget.schemas().isEmpty() || wanted.equals(new HashSet<>(s.schemas())))
              .toList();
      states.stream()
          .max(Comparator.comparingLong(State::polygons))
          .filter(worst -> worst.polygons() > budget.polygons())
          .ifPresent(worst -> over(budget, group, worst));
    }

    private void over(Budget budget, String group, State worst) {
      String state =
          worst.schemas().isEmpty()
              ? "outside all areas"
              : "with " + String.join(" and ", worst.schemas());
      report(
          BudgetRules.OVER_BUDGET,
          group,
          group.isEmpty() ? "the scene" : group,
          worst.polygons(),
          state,
          worst.polygons() - budget.polygons(),
          budget.polygons());
    }

    private Optional<String> group(String name) {
      if (model.groups().contains(name)) {
        return Optional.of(name);
      }
      List<String> alike =
          model.groups().stream().filter(group -> group.equalsIgnoreCase(name)).toList();
      return alike.size() == 1 ? Optional.of(alike.get(0)) : Optional.empty();
    }

    private Set<String> entered() {
      Set<String> entered = new HashSet<>();
      model.areas().forEach(area -> entered.addAll(area.schemas().enter()));
      return entered;
    }

    private Set<String> schemas() {
      Set<String> schemas = entered();
      model.areas().forEach(area -> schemas.addAll(area.schemas().exit()));
      model.objects().forEach(o -> schemas.addAll(o.schemas().choiceBySchema().keySet()));
      return schemas;
    }

    private Optional<String> near(String schema) {
      return SchemaNames.probablyMeant(schema, new ArrayList<>(schemas()));
    }

    private void report(Rule rule, String group, Object... words) {
      ParsedNode node = view.main().scene().named().get(group);
      if (node == null) {
        findings.add(rule, Location.of(view.main().file().name()), "", words);
      } else {
        findings.add(rule, node, words);
      }
    }
  }
}
