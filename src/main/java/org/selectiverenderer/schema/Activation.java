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
 * Which choice each Switch shows, given the areas that the viewer is in. The loops of Figs 48 and
 * 49, with an answer for areas that lie in or overlap each other:
 *
 * <ul>
 *   <li>entering an area activates its schemas, in order; a Switch follows the last one that has a
 *       choice for it, and where several entered areas claim a Switch, the area entered last wins;
 *   <li>leaving an area ends its claims: a Switch that another entered area claims shows that
 *       area's choice, any other follows the exit schemas of the area left, and stays as it is if
 *       they have no choice for it.
 * </ul>
 *
 * <p>A step costs what it changes: for each schema the switches that have a choice for it and show
 * another one are kept, and only these are looked at. A switch that looks elsewhere because another
 * area overrules the schema is looked at too.
 *
 * <p>Not thread-safe.
 *
 * @param <A> key of an area
 * @param <S> key of a switch; both need {@code equals} and {@code hashCode}
 */
public final class Activation<A, S> {
  /**
   * A Switch that is to show another choice.
   *
   * @param schema the schema that makes it so
   */
  public record Change<S>(S switchKey, int from, int to, String schema) {}

  private final Map<A, SensorSchemas> areas = new HashMap<>();
  private final Map<S, SwitchState<S>> switches = new LinkedHashMap<>();
  private final Map<String, Set<SwitchState<S>>> elsewhere = new HashMap<>();
  private final Set<A> entered = new LinkedHashSet<>();
  private final Set<String> left = new LinkedHashSet<>();
  private long order;
  private long looks;

  /** Makes an area known, or gives a known one other schemas from the next step on. */
  public void putArea(A area, SensorSchemas schemas) {
    areas.put(area, schemas);
  }

  /**
   * Forgets an area. If the viewer is in it its claims end, but nobody left it: no exit schema is
   * activated.
   *
   * @return what the other entered areas change thereby
   */
  public List<Change<S>> removeArea(A area) {
    areas.remove(area);
    return entered.remove(area) ? follow(overruled(), List.of()) : List.of();
  }

  /**
   * Makes a switch known, or gives a known one other schemas. It follows the entered areas at once.
   *
   * @param shown the choice that it shows now; a known switch shows what this object last said
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
   * Takes note that a switch shows another choice than this object last said: somebody else, such
   * as a ROUTE, made it so. Nothing changes but what later steps compare with.
   */
  public void noteShown(S key, int choice) {
    SwitchState<S> state = switches.get(key);
    if (state != null) {
      show(state, choice);
    }
  }

  /** Forgets a switch. */
  public void removeSwitch(S key) {
    SwitchState<S> state = switches.remove(key);
    if (state != null) {
      forget(state);
    }
  }

  /**
   * The viewer enters an area; one that is entered already counts as entered last.
   *
   * @return the switches to change, in the order in which they were made known
   * @throws IllegalArgumentException if the area is unknown
   */
  public List<Change<S>> enter(A area) {
    List<String> schemas = schemas(area).enter();
    entered.remove(area);
    entered.add(area);
    return follow(elsewhere(schemas), List.of());
  }

  /**
   * The viewer leaves an area.
   *
   * @return the switches to change, in the order in which they were made known
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

  /** Whether the viewer is in an area. */
  public boolean isEntered(A area) {
    return entered.contains(area);
  }

  /** The areas that the viewer is in, in the order of entering. */
  public List<A> enteredAreas() {
    return List.copyOf(entered);
  }

  /**
   * The schemas in force: first those that leaving areas activated (the main schemas), then those
   * of the entered areas in the order of entering, so that later ones overrule earlier ones.
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

  /** What each switch shows, in the order in which they were made known. */
  public Map<S, Integer> shown() {
    Map<S, Integer> shown = new LinkedHashMap<>();
    switches.values().stream()
        .sorted(Comparator.comparingLong(state -> state.order))
        .forEach(state -> shown.put(state.key, state.shown));
    return shown;
  }

  /** How many times a switch was looked at, for the test of the cost. */
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

  /** The switches that have a choice for one of the schemas and show another one. */
  private Set<SwitchState<S>> elsewhere(List<String> schemas) {
    Set<SwitchState<S>> states = new LinkedHashSet<>();
    for (String schema : schemas) {
      states.addAll(elsewhere.getOrDefault(schema, Set.of()));
    }
    return states;
  }

  /** The switches that an entered area claims and that show something else. */
  private Set<SwitchState<S>> overruled() {
    Set<SwitchState<S>> states = new LinkedHashSet<>();
    for (A area : entered) {
      states.addAll(elsewhere(schemas(area).enter()));
    }
    return states;
  }

  /** Lets each candidate follow the entered areas, or the exit schemas if none claims it. */
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

  /** All schemas that have a say, the weakest first. */
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

    /** The last of the schemas that the switch has a choice for. */
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
