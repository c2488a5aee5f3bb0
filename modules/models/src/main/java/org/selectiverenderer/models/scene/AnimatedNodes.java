package org.selectiverenderer.models.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The nodes of a scene that a node of the model has become, which its animations move. */
public final class AnimatedNodes {
  /**
   * A Transform or HAnimJoint.
   *
   * @param def its DEF name
   * @param binding how its fields follow from those of the model's node
   */
  record Written(String def, JointBinding binding) {}

  private final Map<Integer, List<Written>> written = new HashMap<>();

  /** Adds the Transform that a node has become. */
  public void add(int node, String def) {
    add(node, def, JointBinding.NONE);
  }

  void add(int node, String def, JointBinding binding) {
    written.computeIfAbsent(node, unused -> new ArrayList<>()).add(new Written(def, binding));
  }

  /** Returns whether a node of the model has become any. */
  public boolean has(int node) {
    return written.containsKey(node);
  }

  List<Written> of(int node) {
    return written.getOrDefault(node, List.of());
  }
}
