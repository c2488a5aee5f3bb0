package org.selectiverenderer.browser.nodes.event;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The interpolators of X3D 4.0, 19.4, which differ in how they interpolate between two key values.
 * Every fraction sends a value; outside the keys it is the first or last one. Nothing is sent
 * without a complete key value or for a fraction of NaN.
 */
public final class InterpolatorNode extends Node {
  private final int fraction;
  private final int key;
  private final int keyValue;
  private final int valueChanged;
  private final int components;
  private final boolean many;
  private final boolean scalar;
  private final KeyValueInterpolation blend;

  public InterpolatorNode(
      NodeType type, @Nullable String name, SourceLocation location, KeyValueInterpolation blend) {
    super(type, name, location);
    this.blend = blend;
    fraction = type.indexOf("set_fraction");
    key = type.indexOf("key");
    keyValue = type.indexOf("keyValue");
    valueChanged = type.indexOf("value_changed");
    FieldDefinition output = type.fields().get(valueChanged);
    components = output.type().components();
    many = output.type().multiple();
    scalar = !many && components == 1;
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (field.index() != fraction) {
      super.receive(field, value, cascade);
      return;
    }
    float at = (Float) value;
    float[] keys = (float[]) value(key);
    float[] values = (float[]) value(keyValue);
    int tuples = values.length / components;
    int perKey = many && keys.length > 0 ? tuples / keys.length : 1;
    int count = Math.min(keys.length, perKey == 0 ? 0 : tuples / perKey);
    if (count == 0 || Float.isNaN(at)) {
      return;
    }
    float[] result = between(keys, values, count, perKey * components, at);
    emit(valueChanged, scalar ? (Object) result[0] : result, cascade);
  }

  /**
   * @param length the number of values per key
   */
  private float[] between(float[] keys, float[] values, int count, int length, float at) {
    int low = KeyframeSearch.at(keys, count, at);
    int from = low * length;
    if (low == count - 1 || at <= keys[low]) {
      return Arrays.copyOfRange(values, from, from + length);
    }
    float part = (at - keys[low]) / (keys[low + 1] - keys[low]);
    float[] result = new float[length];
    for (int i = 0; i < length; i += components) {
      blend.between(values, from + i, from + length + i, part, result, i);
    }
    return result;
  }
}
