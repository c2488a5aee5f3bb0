package org.selectiverenderer.polygon;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.schema.SchemaActivation;

/**
 * Searches the states that a scene can reach: enters and leaves its areas in all orders (breadth
 * first) until no new state is found. This includes states that remain after leaving an area
 * without an exit schema, which a single visit does not show.
 */
final class ReachableStateSearch {
  /** The largest number of states, since n areas in one place have 2^n sets. */
  static final int LIMIT = 1000;

  private record Step(Area area, boolean enters) {}

  private record Key(List<Area> entered, Map<ChoiceKey, Integer> shown) {}

  private final List<CountGraphNode> objects;
  private final List<CountedTexture> textures;
  private final List<Area> areas;

  /** Creates the search of a whole scene. */
  ReachableStateSearch(
      List<CountGraphNode> objects, List<CountedTexture> textures, List<Area> areas) {
    this.objects = objects;
    this.textures = textures;
    this.areas = areas;
  }

  /**
   * Returns the states of a part: the state as loaded first, then by the number of areas entered
   * and left.
   */
  List<EnrichmentPolygonModel.State> states(CountGraphNode part) {
    List<EnrichmentPolygonModel.State> states = new ArrayList<>();
    Set<Key> known = new HashSet<>();
    Deque<List<Step>> pending = new ArrayDeque<>();
    pending.add(List.of());
    while (!pending.isEmpty() && known.size() < LIMIT) {
      List<Step> walk = pending.remove();
      SchemaActivation<Area, ChoiceKey> activation = after(walk);
      if (known.add(new Key(activation.enteredAreas(), activation.shown()))) {
        states.add(
            new EnrichmentPolygonModel.State(
                schemas(activation),
                new PolygonCounter(activation.shown()).of(part),
                new CostCounter(activation.shown(), textures).of(part)));
        next(activation.enteredAreas()).forEach(step -> pending.add(with(walk, step)));
      }
    }
    return states;
  }

  private SchemaActivation<Area, ChoiceKey> after(List<Step> walk) {
    SchemaActivation<Area, ChoiceKey> activation =
        ActivationStateFinder.activation(objects, textures, areas);
    for (Step step : walk) {
      if (step.enters) {
        activation.enter(step.area);
      } else {
        activation.exit(step.area);
      }
    }
    return activation;
  }

  private List<Step> next(List<Area> entered) {
    List<Step> steps = new ArrayList<>();
    for (Area area : areas) {
      if (entered.contains(area)) {
        steps.add(new Step(area, false));
      } else {
        List<Area> wider = new ArrayList<>(entered);
        wider.add(area);
        if (OverlappingAreaSets.share(wider)) {
          steps.add(new Step(area, true));
        }
      }
    }
    return steps;
  }

  private static List<Step> with(List<Step> walk, Step step) {
    List<Step> longer = new ArrayList<>(walk);
    longer.add(step);
    return longer;
  }

  private static List<String> schemas(SchemaActivation<Area, ChoiceKey> activation) {
    Set<String> schemas = new LinkedHashSet<>();
    activation.enteredAreas().forEach(area -> schemas.addAll(area.schemas.enter()));
    return List.copyOf(schemas);
  }
}
