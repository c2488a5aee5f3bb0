package org.selectiverenderer.experiment.headlog;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.Instance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.scene.Node;

/** What the object that a shape belongs to is called. */
final class ObjectNames {
  private ObjectNames() {}

  /** The nearest named Switch above a shape: the one that holds the object's versions. */
  static @Nullable Node switchOf(ShapeInstance shape) {
    for (Instance at = shape; at != null; at = at.parent()) {
      Node node = at.node();
      if (node.type().name().equals("Switch") && name(node) != null) {
        return node;
      }
    }
    return null;
  }

  /**
   * The DEF of its Switch; else that of the Inline it came with, which holds an object as a rule;
   * else the nearest DEF at it or above; empty when there is none.
   */
  static String of(ShapeInstance shape) {
    Node owner = switchOf(shape);
    if (owner != null) {
      return String.valueOf(owner.name());
    }
    String nearest = "";
    for (Instance at = shape; at != null; at = at.parent()) {
      String name = name(at.node());
      if (name != null && at.node().type().name().equals("Inline")) {
        return name;
      }
      if (name != null && nearest.isEmpty()) {
        nearest = name;
      }
    }
    return nearest;
  }

  private static @Nullable String name(Node node) {
    String name = node.name();
    return name == null || name.isEmpty() ? null : name;
  }
}
