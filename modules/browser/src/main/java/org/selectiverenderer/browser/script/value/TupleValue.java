package org.selectiverenderer.browser.script.value;

import java.util.Arrays;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * A vector, colour, rotation or matrix. Its components have indices and, except for matrices,
 * names. They are rounded to single precision when they become the value of a field.
 */
@SuppressWarnings("serial") // See FieldValue.
final class TupleValue extends FieldValue {
  private final double[] components;

  /**
   * @param components the components; the array is not copied
   */
  TupleValue(FieldType type, double[] components) {
    super(type);
    this.components = components;
  }

  /** Returns a copy of its components. */
  double[] components() {
    return components.clone();
  }

  double at(int index) {
    return components[index];
  }

  /** Replaces the components. */
  void set(double... values) {
    beforeChange();
    System.arraycopy(values, 0, components, 0, components.length);
    changed();
  }

  /** Returns the one-letter names of the components in order; empty for matrices. */
  private static String names(FieldType type) {
    return switch (type) {
      case SFColor, SFColorRGBA -> "rgba";
      case SFVec2f, SFVec3f, SFVec4f, SFVec2d, SFVec3d, SFVec4d -> "xyzw";
      case SFRotation -> "xyz";
      default -> "";
    };
  }

  private int index(String name) {
    if (type() == FieldType.SFRotation && name.equals("angle")) {
      return 3;
    }
    int index = name.length() == 1 ? names(type()).indexOf(name.charAt(0)) : -1;
    return index < components.length ? index : -1;
  }

  @Override
  public boolean has(String name, Scriptable start) {
    return index(name) >= 0 || super.has(name, start);
  }

  @Override
  public Object get(String name, Scriptable start) {
    int index = index(name);
    return index >= 0 ? components[index] : super.get(name, start);
  }

  @Override
  public void put(String name, Scriptable start, Object value) {
    int index = index(name);
    if (index >= 0) {
      put(index, start, value);
    } else {
      super.put(name, start, value);
    }
  }

  @Override
  public boolean has(int index, Scriptable start) {
    return index >= 0 && index < components.length;
  }

  @Override
  public Object get(int index, Scriptable start) {
    return has(index, start) ? components[index] : Undefined.instance;
  }

  @Override
  public void put(int index, Scriptable start, Object value) {
    if (!has(index, start)) {
      throw ScriptRuntime.rangeError(
          "%s has %s components; index %s is out of range"
              .formatted(type(), components.length, index));
    }
    double number = ScriptRuntime.toNumber(value);
    beforeChange();
    components[index] = number;
    changed();
  }

  @Override
  public Object toField() {
    if (type().kind() == FieldType.Kind.DOUBLE) {
      return components.clone();
    }
    float[] floats = new float[components.length];
    for (int i = 0; i < floats.length; i++) {
      floats[i] = (float) components[i];
    }
    return floats;
  }

  @Override
  String text() {
    boolean single = type().kind() == FieldType.Kind.FLOAT;
    StringBuilder text = new StringBuilder();
    for (double component : components) {
      text.append(text.length() == 0 ? "" : " ");
      text.append(number(component, single));
    }
    return text.toString();
  }

  /** Formats a number as scripts do; one of single precision with no more digits than it has. */
  static String number(double value, boolean single) {
    float near = (float) value;
    boolean finite = single && !Float.isInfinite(near) && !Float.isNaN(near);
    return ScriptRuntime.numberToString(
        finite ? Double.parseDouble(Float.toString(near)) : value, 10);
  }

  boolean same(TupleValue other) {
    return type() == other.type() && Arrays.equals(components, other.components);
  }
}
