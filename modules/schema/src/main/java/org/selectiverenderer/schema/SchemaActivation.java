package org.selectiverenderer.schema;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Decides which choice each Switch shows, given the areas that the viewer is in. It implements the
 * loops of Figs 48 and 49 of the thesis, extended to nested and overlapping areas:
 *
 * <ul>
 *   <li>Entering an area activates its schemas, in order. A Switch shows the choice of the last of
 *       them that it has a choice for; of several entered areas the one entered last takes
 *       precedence.
 *   <li>Leaving an area ends its precedence. A Switch that has a choice for a schema of another
 *       entered area shows that choice; any other Switch shows its choice for the exit schemas of
 *       the area left, and is unchanged if it has none.
 * </ul>
 *
 * <p>A step takes time proportional to its changes: for each schema the class keeps the switches
 * that have a choice for it and show another one, and a step examines only these, including
 * switches for which another area takes precedence.
 *
 * <p>Not thread-safe.
 *
 * @param <A> key of an area
 * @param <S> key of a switch; both need {@code equals} and {@code hashCode}
 */
public final class SchemaActivation<A, S> {
  /**
   * A change of the choice that a Switch shows.
   *
   * @param schema the schema that causes the change
   */
  public record Change<S>(S switchKey, int from, int to, String schema) {}

  private final Map<A, SensorSchemas> areas = new HashMap<>();
  private final Map<S, SwitchState<S>> switches = new LinkedHashMap<>();
  private final Map<String, Set<SwitchState<S>>> elsewhere = new HashMap<>();
  private final Set<A> entered = new LinkedHashSet<>();
  private final Set<String> left = new LinkedHashSet<>();
  private long order;
  private long looks;

  /** Adds an area, or replaces the schemas of a known one from the next step on. */
  public void putArea(A area, SensorSchemas schemas) {
    areas.put(area, schemas);
  }

  /**
   * Removes an area. If the viewer is in it, its precedence ends, but no exit schema is activated,
   * since the viewer has not left it.
   *
   * @return the changes due to the other entered areas
   */
  public List<Change<S>> removeArea(A area) {
    areas.remove(area);
    return entered.remove(area) ? follow(overruled(), List.of()) : List.of();
  }

  /**
   * Adds a switch, or replaces the schemas of a known one. It follows the entered areas at once.
   *
   * @param shown the choice that a new switch shows now; ignored for a known one
   */
  public Optional<Change<S>> putSwitch(S key, SwitchSchemas schemas, int shown) {
    SwitchState<S> known = switches.remove(key);
    SwitchState<S> state;
    if (known == null) {
      state = new SwitchState<>(key, order++, schemas.choiceBySchema(), shown);
    } else {
      forget(known);
      state = new SwitchState<>(key, known.order, schemas.choiceBySchema(), known.shown);
    }
    switches.put(key, state);
    show(state, state.shown);
    return follow(Set.of(state), List.of()).stream().findFirst();
  }

  /**
   * Records that a switch shows another choice than this object last set, because of a ROUTE, for
   * example. Later steps compare with this choice.
   */
  public void noteShown(S key, int choice) {
    SwitchState<S> state = switches.get(key);
    if (state != null) {
      show(state, choice);
    }
  }

  /** Removes a switch. */
  public void removeSwitch(S key) {
    SwitchState<S> state = switches.remove(key);
    if (state != null) {
      forget(state);
    }
  }

  /**
   * Records that the viewer enters an area; an area already entered becomes the one entered last.
   *
   * @return the switches to change, in the order in which they were added
   * @throws IllegalArgumentException if the area is unknown
   */
  public List<Change<S>> enter(A area) {
    List<String> schemas = schemas(area).enter();
    entered.remove(area);
    entered.add(area);
    return follow(elsewhere(schemas), List.of());
  }

  /**
   * Records that the viewer leaves an area.
   *
   * @return the switches to change, in the order in which they were added
   * @throws IllegalArgumentException if the area is unknown
   */
  public List<Change<S>> exit(A area) {
    SensorSchemas schemas = schemas(area);
    entered.remove(area);
    schemas.enter().forEach(left::remove);
    left.removeAll(schemas.exit());
    left.addAll(schemas.exit());
    Set<SwitchState<S>> candidates = elsewhere(schemas.exit());
    candidates.addAll(overruled());
    return follow(candidates, schemas.exit());
  }

  /** Returns whether the viewer is in an area. */
  public boolean isEntered(A area) {
    return entered.contains(area);
  }

  /** Returns the areas that the viewer is in, in the order of entering. */
  public List<A> enteredAreas() {
    return List.copyOf(entered);
  }

  /**
   * Returns the active schemas in ascending precedence: first the exit schemas of areas left (the
   * main schemas), then those of the entered areas in the order of entering.
   */
  public List<String> activeSchemas() {
    Set<String> ofEntered = new LinkedHashSet<>();
    for (A area : entered) {
      List<String> enter = schemas(area).enter();
      ofEntered.removeAll(enter);
      ofEntered.addAll(enter);
    }
    Set<String> all = new LinkedHashSet<>(left);
    all.removeAll(ofEntered);
    all.addAll(ofEntered);
    return List.copyOf(all);
  }

  /** Returns the choice that each switch shows, in the order in which they were added. */
  public Map<S, Integer> shown() {
    Map<S, Integer> shown = new LinkedHashMap<>();
    switches.values().stream()
        .sorted(Comparator.comparingLong(state -> state.order))
        .forEach(state -> shown.put(state.key, state.shown));
    return shown;
  }

  /** Returns how many times a switch was examined, for the test of the complexity. */
  long looks() {
    return looks;
  }

  private SensorSchemas schemas(A area) {
    SensorSchemas schemas = areas.get(area);
    if (schemas == null) {
      throw new IllegalArgumentException("there is no area " + area);
    }
    return schemas;
  }

  /** Returns the switches that have a choice for one of the schemas and show another one. */
  private Set<SwitchState<S>> elsewhere(List<String> schemas) {
    Set<SwitchState<S>> states = new LinkedHashSet<>();
    for (String schema : schemas) {
      states.addAll(elsewhere.getOrDefault(schema, Set.of()));
    }
    return states;
  }

  /** Returns the switches with a choice for a schema of an entered area that show another one. */
  private Set<SwitchState<S>> overruled() {
    Set<SwitchState<S>> states = new LinkedHashSet<>();
    for (A area : entered) {
      states.addAll(elsewhere(schemas(area).enter()));
    }
    return states;
  }

  /** Sets each candidate by the entered areas, or by the exit schemas if it has no such choice. */
  private List<Change<S>> follow(Set<SwitchState<S>> candidates, List<String> exit) {
    looks += candidates.size();
    List<List<String>> claims = claims(exit);
    List<SwitchState<S>> inOrder = new ArrayList<>(candidates);
    inOrder.sort(Comparator.comparingLong(state -> state.order));
    List<Change<S>> changes = new ArrayList<>();
    for (SwitchState<S> state : inOrder) {
      String schema = state.lastNamed(claims);
      if (schema == null) {
        continue;
      }
      int to = state.choices.get(schema);
      if (to != state.shown) {
        changes.add(new Change<>(state.key, state.shown, to, schema));
        show(state, to);
      }
    }
    return changes;
  }

  /** Returns the schemas to consider, in ascending precedence. */
  private List<List<String>> claims(List<String> exit) {
    List<List<String>> claims = new ArrayList<>();
    claims.add(exit);
    for (A area : entered) {
      claims.add(schemas(area).enter());
    }
    return claims;
  }

  private void show(SwitchState<S> state, int choice) {
    state.shown = choice;
    state.choices.forEach(
        (schema, wanted) -> {
          if (wanted == choice) {
            remove(schema, state);
          } else {
            elsewhere.computeIfAbsent(schema, key -> new LinkedHashSet<>()).add(state);
          }
        });
  }

  private void forget(SwitchState<S> state) {
    state.choices.keySet().forEach(schema -> remove(schema, state));
  }

  private void remove(String schema, SwitchState<S> state) {
    Set<SwitchState<S>> states = elsewhere.get(schema);
    if (states != null && states.remove(state) && states.isEmpty()) {
      elsewhere.remove(schema);
    }
  }

  private static final class SwitchState<S> {
    final S key;
    final long order;
    final Map<String, Integer> choices;
    int shown;

    SwitchState(S key, long order, Map<String, Integer> choices, int shown) {
      this.key = key;
      this.order = order;
      this.choices = Map.copyOf(choices);
      this.shown = shown;
    }

    /** Returns the last of the schemas that the switch has a choice for, or null. */
    @Nullable String lastNamed(List<List<String>> claims) {
      for (int i = claims.size() - 1; i >= 0; i--) {
        List<String> schemas = claims.get(i);
        for (int j = schemas.size() - 1; j >= 0; j--) {
          if (choices.containsKey(schemas.get(j))) {
            return schemas.get(j);
          }
        }
      }
      return null;
    }
  }
}
