package org.selectiverenderer.browser.nodes.hanim;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/**
 * The rest-pose points or normals of a node, whose field holds the deformed ones. A value that
 * another sender writes to the field becomes the new rest pose.
 */
final class RestPoseVertices {
  private final Node node;
  private final int field;
  private float[] rest = {};
  private float @Nullable [] derived;

  /**
   * @param node a Coordinate or Normal
   * @param field the field with the points or vectors
   */
  RestPoseVertices(Node node, String field) {
    this.node = node;
    this.field = node.type().indexOf(field);
  }

  Node node() {
    return node;
  }

  /** Returns whether a change of the node's field came from another sender. */
  boolean others(int changed) {
    return changed == field && node.value(field) != derived;
  }

  /** Returns the values of the rest pose, as x, y, z. */
  float[] rest() {
    float[] now = (float[]) node.value(field);
    if (now != derived) {
      rest = now;
      derived = null;
    }
    return rest;
  }

  /** Writes deformed values to the field; does nothing if they are there already. */
  void show(float[] deformed) {
    if (!Arrays.equals((float[]) node.value(field), deformed)) {
      derived = deformed;
      node.derive(field, deformed);
    }
  }
}
