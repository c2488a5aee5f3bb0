package org.selectiverenderer.validation.budget;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.polygon.count.SceneModel;
import org.selectiverenderer.polygon.count.SceneModel.State;
import org.selectiverenderer.schema.SchemaNames;
import org.selectiverenderer.validation.Budget;

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
  record Holds(String group, List<State> states) implements BudgetMatch {}

  /**
   * The scene has a group or schema with a name similar to that in the budget, probably a
   * misspelling.
   *
   * @param group the group in which the schema is missing, or the group with the similar name
   */
  record Slip(String group, String kind, String name, String near) implements BudgetMatch {}

  /** The scene has nothing that the budget names. */
  record None() implements BudgetMatch {}

  static BudgetMatch of(Budget budget, SceneModel model) {
    String wanted = budget.scope();
    Optional<String> group = wanted.isEmpty() ? Optional.of("") : group(wanted, model);
    if (group.isEmpty()) {
      return SchemaNames.probablyMeant(wanted, model.groups())
          .<BudgetMatch>map(near -> new Slip(near, "group", wanted, near))
          .orElseGet(None::new);
    }
    Set<String> known = schemas(model);
    for (String schema : budget.schemas()) {
      if (!known.contains(schema)) {
        return SchemaNames.probablyMeant(schema, new ArrayList<>(known))
            .<BudgetMatch>map(near -> new Slip(group.get(), "schema", schema, near))
            .orElseGet(None::new);
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
    return states.isEmpty() ? new None() : new Holds(group.get(), states);
  }

  private static Optional<String> group(String name, SceneModel model) {
    if (model.groups().contains(name)) {
      return Optional.of(name);
    }
    List<String> alike =
        model.groups().stream().filter(group -> group.equalsIgnoreCase(name)).toList();
    return alike.size() == 1 ? Optional.of(alike.get(0)) : Optional.empty();
  }

  private static Set<String> entered(SceneModel model) {
    Set<String> entered = new HashSet<>();
    model.areas().forEach(area -> entered.addAll(area.schemas().enter()));
    return entered;
  }

  private static Set<String> schemas(SceneModel model) {
    Set<String> schemas = entered(model);
    model.areas().forEach(area -> schemas.addAll(area.schemas().exit()));
    model.objects().forEach(o -> schemas.addAll(o.schemas().choiceBySchema().keySet()));
    return schemas;
  }
}
