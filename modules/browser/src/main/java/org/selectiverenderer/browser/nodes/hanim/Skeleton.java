package org.selectiverenderer.browser.nodes.hanim;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.nodes.group.TransformNode;
import org.selectiverenderer.browser.scene.Node;

/**
 * The joint hierarchy of a humanoid: each joint once, parents before children.
 *
 * @param joints the joint nodes
 * @param parents the index of each joint's parent; -1 for root joints
 */
record Skeleton(List<TransformNode> joints, int[] parents) {

  private record Open(Node node, int parent) {}

  /**
   * @param roots the humanoid's field {@code skeleton}
   */
  static Skeleton of(List<Node> roots) {
    List<TransformNode> joints = new ArrayList<>();
    List<Integer> parents = new ArrayList<>();
    Set<Node> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<Open> open = new ArrayDeque<>();
    roots.forEach(root -> open.add(new Open(root, -1)));
    while (!open.isEmpty()) {
      Open next = open.remove();
      if (next.node instanceof TransformNode joint
          && joint.type().name().equals("HAnimJoint")
          && seen.add(joint)) {
        int number = joints.size();
        joints.add(joint);
        parents.add(next.parent);
        joint.children().forEach(child -> open.add(new Open(child, number)));
      }
    }
    return new Skeleton(
        List.copyOf(joints), parents.stream().mapToInt(Integer::intValue).toArray());
  }

  /** Returns the present matrix from each joint's coordinates to the humanoid's. */
  Matrix4dc[] placements() {
    Matrix4dc[] all = new Matrix4dc[joints.size()];
    for (int i = 0; i < all.length; i++) {
      Matrix4d own = joints.get(i).placement().orElseGet(Matrix4d::new);
      all[i] = parents[i] < 0 ? own : all[parents[i]].mul(own, own);
    }
    return all;
  }
}
