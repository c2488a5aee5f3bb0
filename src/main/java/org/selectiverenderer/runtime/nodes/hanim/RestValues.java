package org.selectiverenderer.runtime.nodes.hanim;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;

/**
 * The points or normals of one node as its author gave them, while the node holds deformed ones. A
 * value that others put there meanwhile becomes the new rest.
 */
final class RestValues {
  private final Node node;
  private final int field;
  private float[] rest = {};
  private float @Nullable [] derived;

  /**
   * @param node a Coordinate or Normal
   * @param field its points or vectors
   */
  RestValues(Node node, String field) {
    this.node = node;
    this.field = node.type().indexOf(field);
  }

  Node node() {
    return node;
  }

  /** Whether a change of the node's field is none of its own. */
  boolean others(int changed) {
    return changed == field && node.value(field) != derived;
  }

  /** The values that nothing has deformed; x, y, z each. */
  float[] rest() {
    float[] now = (float[]) node.value(field);
    if (now != derived) {
      rest = now;
      derived = null;
    }
    return rest;
  }

  /** Shows deformed values; does nothing when they are shown already. */
  void show(float[] deformed) {
    if (!Arrays.equals((float[]) node.value(field), deformed)) {
      derived = deformed;
      node.derive(field, deformed);
    }
  }
}
