package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/**
 * The world transforms of graph nodes: one for each instance, from the coordinates of its parent to
 * the world.
 */
final class InstanceTransforms {
  /** The largest number of instances of all nodes together. */
  static final int LIMIT = 10_000;

  private final Set<CountGraphNode> wanted;
  private final Map<CountGraphNode, List<Matrix4dc>> places = new IdentityHashMap<>();
  private final Map<CountGraphNode, Boolean> leads = new IdentityHashMap<>();
  private int count;
  private boolean complete = true;

  InstanceTransforms(CountGraphNode root, Set<CountGraphNode> wanted) {
    this.wanted = wanted;
    visit(root, new Matrix4d());
  }

  /**
   * Returns the transforms from the parent coordinates of each instance to the world, in document
   * order.
   */
  List<Matrix4dc> of(CountGraphNode item) {
    return places.getOrDefault(item, List.of());
  }

  /** Returns whether these are all instances. */
  boolean complete() {
    return complete;
  }

  private void visit(CountGraphNode item, Matrix4dc world) {
    if (!leads(item)) {
      return;
    }
    if (count >= LIMIT) {
      complete = false;
      return;
    }
    if (wanted.contains(item)) {
      places.computeIfAbsent(item, key -> new ArrayList<>()).add(world);
      count++;
    }
    Matrix4dc content =
        item.placement.isEmpty() ? world : world.mul(item.placement.get(), new Matrix4d());
    item.children.forEach(child -> visit(child, content));
  }

  private boolean leads(CountGraphNode item) {
    Boolean known = leads.get(item);
    if (known == null) {
      known = wanted.contains(item) || item.children.stream().anyMatch(this::leads);
      leads.put(item, known);
    }
    return known;
  }
}
