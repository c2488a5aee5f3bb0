package org.selectiverenderer.browser.nodes.hanim;

import java.util.List;
import org.selectiverenderer.browser.scene.Node;

/**
 * Applies the HAnimDisplacers of a joint or segment, which move single points (X3D 4.0, 26.3.1).
 */
final class Displacers {
  private Displacers() {}

  /** Returns the displacers of a joint or segment. */
  static List<Node> of(Node holder) {
    return holder.nodes("displacers").stream()
        .filter(node -> node.type().name().equals("HAnimDisplacer"))
        .toList();
  }

  /**
   * Adds to each point that a displacer names its displacement times the weight. Indices without a
   * point or a displacement are ignored.
   *
   * @param points the points as x, y, z; changed in place
   */
  static void apply(List<Node> displacers, float[] points) {
    for (Node displacer : displacers) {
      float weight = displacer.number("weight");
      if (weight == 0 || !Float.isFinite(weight)) {
        continue;
      }
      int[] index = displacer.ints("coordIndex");
      float[] by = displacer.floats("displacements");
      for (int i = 0; i < Math.min(index.length, by.length / 3); i++) {
        int at = index[i];
        if (at >= 0 && at < points.length / 3) {
          for (int axis = 0; axis < 3; axis++) {
            points[3 * at + axis] += weight * by[3 * i + axis];
          }
        }
      }
    }
  }
}
