package org.selectiverenderer.browser.nodes.event;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A node that answers a fraction with a value interpolated between two keys (X3D 4.0, 19.2.1).
 * Nothing is sent without a complete key value or for a fraction of NaN.
 */
public abstract class KeyframeNode extends Node {
  private final int fraction;
  private final int key;

  protected KeyframeNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    fraction = type.indexOf("set_fraction");
    key = type.indexOf("key");
  }

  @Override
  protected final void receive(
      FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (field.index() != fraction) {
      super.receive(field, value, cascade);
      return;
    }
    float at = (Float) value;
    float[] keys = (float[]) value(key);
    int count = Math.min(keys.length, values());
    if (count == 0 || Float.isNaN(at)) {
      return;
    }
    int low = KeyframeSearch.at(keys, count, at);
    boolean between = low < count - 1 && at > keys[low];
    send(low, count, between ? (at - keys[low]) / (keys[low + 1] - keys[low]) : 0, cascade);
  }

  /** Returns the number of key values. */
  protected abstract int values();

  /**
   * Answers a fraction.
   *
   * @param low the last key that is not above the fraction; 0 below the first key
   * @param count the number of keys to use, at least 1
   * @param part the position between that key and the next, from 0; 0 at a key and outside the keys
   */
  protected abstract void send(int low, int count, float part, EventCascade cascade);
}
