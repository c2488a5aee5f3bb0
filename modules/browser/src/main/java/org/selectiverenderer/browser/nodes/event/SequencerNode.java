package org.selectiverenderer.browser.nodes.event;

import java.lang.reflect.Array;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * BooleanSequencer and IntegerSequencer: step through key values (X3D 4.0, X3DSequencerNode,
 * 30.3.1). A fraction sends the value of the last key not above it if that key differs from the one
 * before; next and previous wrap around the ends.
 */
public final class SequencerNode extends Node {
  private final int fraction;
  private final int next;
  private final int previous;
  private final int key;
  private final int keyValue;
  private final int valueChanged;
  private int at = -1;

  public SequencerNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    fraction = type.indexOf("set_fraction");
    next = type.indexOf("next");
    previous = type.indexOf("previous");
    key = type.indexOf("key");
    keyValue = type.indexOf("keyValue");
    valueChanged = type.indexOf("value_changed");
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    float[] keys = (float[]) value(key);
    int count = Math.min(keys.length, Array.getLength(value(keyValue)));
    if (field.index() == fraction) {
      if (count > 0 && !Float.isNaN((Float) value)) {
        step(KeyframeSearch.at(keys, count, (Float) value), cascade);
      }
    } else if (field.index() == next || field.index() == previous) {
      if (count > 0 && (Boolean) value) {
        int from = field.index() == next ? at : Math.max(at, 0);
        step(Math.floorMod(from + (field.index() == next ? 1 : -1), count), cascade);
      }
    } else {
      super.receive(field, value, cascade);
      if (field.index() == key || field.index() == keyValue) {
        at = -1; // Keys changed: the next fraction sends a value.
      }
    }
  }

  private void step(int to, EventCascade cascade) {
    if (to != at) {
      at = to;
      emit(valueChanged, Array.get(value(keyValue), to), cascade);
    }
  }
}
