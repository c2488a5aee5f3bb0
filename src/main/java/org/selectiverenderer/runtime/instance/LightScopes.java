package org.selectiverenderer.runtime.instance;

import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Assigns to every shape the lights that reach it, in document order, and the effects (fog, clip
 * planes, environment lights) whose scope it is in; siblings share both.
 */
final class LightScopes {
  private final Comparator<LightInstance> order;

  private LightScopes(List<LightInstance> lights) {
    Map<LightInstance, Integer> numbers = new IdentityHashMap<>();
    lights.forEach(light -> numbers.put(light, numbers.size()));
    order = Comparator.comparing(numbers::get);
  }

  /**
   * Assigns lights and effects to all shapes of a tree.
   *
   * @param lists the instances of the tree by kind
   */
  static void tell(GroupInstance root, InstanceLists lists) {
    List<LightInstance> global =
        lists.lights.stream().filter(light -> light.light().global()).toList();
    new LightScopes(lists.lights).tell(root, global, Surroundings.of(lists.environments));
  }

  private void tell(GroupInstance group, List<LightInstance> above, Surroundings around) {
    List<LightInstance> reaching = group.lit(above, order);
    Surroundings within = around.within(group.children);
    for (Instance child : group.children) {
      if (child instanceof GroupInstance below) {
        tell(below, reaching, within);
      } else if (child instanceof ShapeInstance shape) {
        shape.light(reaching);
        shape.surround(within);
      }
    }
  }
}
