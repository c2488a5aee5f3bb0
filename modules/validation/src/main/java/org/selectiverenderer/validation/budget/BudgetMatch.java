package org.selectiverenderer.validation.budget;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.State;
import org.selectiverenderer.schema.SchemaNameMatcher;
import org.selectiverenderer.validation.CostBudget;

/**
 * The result of matching a budget to a scene. A group is found by its DEF name, else by the only
 * DEF name that differs in letter case.
 */
sealed interface BudgetMatch {
  /**
   * The budget applies to the scene.
   *
   * @param group DEF name; empty for the whole scene
   * @param states the states that the budget is for, at least one
   */
  record Match(String group, List<State> states) implements BudgetMatch {}

  /**
   * The scene has a group or schema with a name similar to that in the budget, probably a
   * misspelling.
   *
   * @param group the group in which the schema is missing, or the group with the similar name
   */
  record NearMiss(String group, String kind, String name, String near) implements BudgetMatch {}

  /** The scene has nothing that the budget names. */
  record NoMatch() implements BudgetMatch {}

  static BudgetMatch of(CostBudget budget, EnrichmentPolygonModel model) {
    String wanted = budget.scope();
    Optional<String> group = wanted.isEmpty() ? Optional.of("") : group(wanted, model);
    if (group.isEmpty()) {
      return SchemaNameMatcher.probablyMeant(wanted, model.groups())
          .<BudgetMatch>map(near -> new NearMiss(near, "group", wanted, near))
          .orElseGet(NoMatch::new);
    }
    Set<String> known = schemas(model);
    for (String schema : budget.schemas()) {
      if (!known.contains(schema)) {
        return SchemaNameMatcher.probablyMeant(schema, new ArrayList<>(known))
            .<BudgetMatch>map(near -> new NearMiss(group.get(), "schema", schema, near))
            .orElseGet(NoMatch::new);
      }
    }
    // Schemas that no area activates on entering are active where the viewer is in no area.
    Set<String> active = new HashSet<>(budget.schemas());
    active.retainAll(entered(model));
    List<State> states =
        model.states(group.get()).stream()
            .filter(
                state ->
                    budget.schemas().isEmpty() || active.equals(new HashSet<>(state.schemas())))
            .toList();
    return states.isEmpty() ? new NoMatch() : new Match(group.get(), states);
  }

  private static Optional<String> group(String name, EnrichmentPolygonModel model) {
    if (model.groups().contains(name)) {
      return Optional.of(name);
    }
    List<String> alike =
        model.groups().stream().filter(group -> group.equalsIgnoreCase(name)).toList();
    return alike.size() == 1 ? Optional.of(alike.get(0)) : Optional.empty();
  }

  private static Set<String> entered(EnrichmentPolygonModel model) {
    Set<String> entered = new HashSet<>();
    model.areas().forEach(area -> entered.addAll(area.schemas().enter()));
    return entered;
  }

  private static Set<String> schemas(EnrichmentPolygonModel model) {
    Set<String> schemas = entered(model);
    model.areas().forEach(area -> schemas.addAll(area.schemas().exit()));
    model.objects().forEach(o -> schemas.addAll(o.schemas().choiceBySchema().keySet()));
    return schemas;
  }
}
