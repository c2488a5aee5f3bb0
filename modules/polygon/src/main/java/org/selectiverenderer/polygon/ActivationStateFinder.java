package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SwitchSchemas;

/**
 * Finds the states that a scope can be in: as loaded, in each area, and in each set of overlapping
 * areas. In every state the versions shown are what {@link SchemaActivation} says after the viewer
 * has entered the areas one after the other, in document order. Where another order of entering
 * gives another number of polygons, because areas show different versions of an object, that order
 * is a separate state.
 */
final class ActivationStateFinder {
  private static final int MAX_ORDERED = 4;

  private final List<CountGraphNode> objects;
  private final List<CountedTexture> textures;
  private final List<Area> areas;

  /**
   * @param objects versioned objects of the whole scene
   * @param textures textures whose pictures are qualities of objects
   * @param areas areas of the whole scene
   */
  ActivationStateFinder(
      List<CountGraphNode> objects, List<CountedTexture> textures, List<Area> areas) {
    this.objects = objects;
    this.textures = textures;
    this.areas = areas;
  }

  /**
   * A state of a scope.
   *
   * @param schemas schemas as in {@link SceneStatistics.StateCount}
   * @param shown the shown version of each object and level of each texture
   */
  record ActivationState(
      List<String> schemas, long polygons, RenderingCost cost, Map<ChoiceKey, Integer> shown) {
    StateCount count(long high) {
      return StateCount.of(schemas, polygons, high, cost);
    }
  }

  /**
   * @param sets sets of areas of the scope, each in document order
   */
  List<ActivationState> states(CountedRegion scope, Collection<List<Area>> sets) {
    List<ActivationState> states = new ArrayList<>();
    SchemaActivation<Area, ChoiceKey> start = activation(objects, textures, areas);
    states.add(state(scope, mainSchemas(scope), start));
    Set<List<String>> listed = new HashSet<>();
    listed.add(states.get(0).schemas());
    for (List<Area> set : sets) {
      Set<List<Object>> counts = new HashSet<>();
      for (List<Area> order : orders(set)) {
        SchemaActivation<Area, ChoiceKey> activation = activation(objects, textures, areas);
        order.forEach(activation::enter);
        ActivationState state = state(scope, activation.activeSchemas(), activation);
        boolean other = counts.add(List.of(state.polygons(), state.cost().textureBytes()));
        if (other && listed.add(state.schemas())) {
          states.add(state);
        }
      }
    }
    return states;
  }

  /** Returns the activation of a scene as loaded, before the viewer has entered any area. */
  static SchemaActivation<Area, ChoiceKey> activation(
      List<CountGraphNode> objects, List<CountedTexture> textures, List<Area> areas) {
    SchemaActivation<Area, ChoiceKey> activation = new SchemaActivation<>();
    areas.forEach(area -> activation.putArea(area, area.schemas));
    for (CountGraphNode object : objects) {
      activation.putSwitch(object, object.versions.orElseThrow(), object.whichChoice());
    }
    for (CountedTexture texture : textures) {
      activation.putSwitch(texture, texture.schemas(), texture.atStart());
    }
    return activation;
  }

  private ActivationState state(
      CountedRegion scope, List<String> schemas, SchemaActivation<Area, ChoiceKey> activation) {
    Map<ChoiceKey, Integer> shown = activation.shown();
    return new ActivationState(
        schemas,
        new PolygonCounter(shown).of(scope.item()),
        new CostCounter(shown, textures).of(scope.item()),
        shown);
  }

  /**
   * Returns the schemas that all objects which know them follow as loaded; those that areas
   * activate are left out unless no other remains.
   */
  private List<String> mainSchemas(CountedRegion scope) {
    Map<String, Boolean> followed = new LinkedHashMap<>();
    for (CountGraphNode object : scope.objects()) {
      SwitchSchemas versions = object.versions.orElseThrow();
      versions
          .choiceBySchema()
          .forEach(
              (schema, choice) ->
                  followed.merge(schema, choice == object.whichChoice(), Boolean::logicalAnd));
    }
    followed.values().removeIf(all -> !all);
    Set<String> entered = new HashSet<>();
    areas.forEach(area -> entered.addAll(area.schemas.enter()));
    List<String> main = followed.keySet().stream().filter(s -> !entered.contains(s)).toList();
    return main.isEmpty() ? List.copyOf(followed.keySet()) : main;
  }

  /** Returns all orders of a small set, the given one first; of a large set only the given one. */
  private static List<List<Area>> orders(List<Area> set) {
    if (set.size() > MAX_ORDERED) {
      return List.of(set);
    }
    List<List<Area>> orders = new ArrayList<>();
    permute(List.of(), new LinkedHashSet<>(set), orders);
    return orders;
  }

  private static void permute(List<Area> begun, Set<Area> rest, List<List<Area>> orders) {
    if (rest.isEmpty()) {
      orders.add(begun);
    }
    for (Area next : rest) {
      List<Area> longer = new ArrayList<>(begun);
      longer.add(next);
      Set<Area> others = new LinkedHashSet<>(rest);
      others.remove(next);
      permute(longer, others, orders);
    }
  }
}
