package org.selectiverenderer.browser.script.value;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.NativeArray;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * Converts between the values of {@link FieldType} and those of scripts: booleans, numbers,
 * strings, {@link FieldValue} and {@link NodeValue}. Other script values cause a TypeError.
 */
public final class FieldValueConverter {
  private final Map<FieldType, Scriptable> prototypes = new EnumMap<>(FieldType.class);
  private final Scriptable scope;
  private @Nullable NodeAccess access;

  /**
   * @param scope the scope of the objects' constructors
   */
  public FieldValueConverter(Scriptable scope) {
    this.scope = scope;
  }

  /** Sets the running script, on whose behalf nodes are read and written from now on. */
  public void accessBy(@Nullable NodeAccess running) {
    access = running;
  }

  void prototype(FieldType type, Scriptable prototype) {
    prototypes.put(type, prototype);
  }

  private <T extends ScriptableObject> T placed(FieldType type, T object) {
    object.setParentScope(scope);
    object.setPrototype(prototypes.get(type));
    return object;
  }

  /**
   * Converts a field's value to a script value.
   *
   * @param value as {@link FieldType} represents it
   * @param holder called when a script changes the object in place, or null
   */
  public @Nullable Object toScript(
      FieldType type, @Nullable Object value, @Nullable Runnable holder) {
    if (type == FieldType.SFNode) {
      return value == null ? null : node((Node) value);
    }
    if (value == null) {
      return Undefined.instance;
    }
    if (type.multiple()) {
      return held(placed(type, new ArrayValue(this, type, value)), holder);
    }
    if (type == FieldType.SFImage) {
      return held(image((int[]) value), holder);
    }
    if (type.components() > 1) {
      return held(tuple(type, doubles(value)), holder);
    }
    return value instanceof Float number ? (Object) number.doubleValue() : value;
  }

  /**
   * Converts a field's value to a script value whose changes in place are reported.
   *
   * @param changed receives the new value as {@link FieldType} represents it
   */
  public @Nullable Object held(
      FieldType type, @Nullable Object value, Consumer<@Nullable Object> changed) {
    Object made = toScript(type, value, null);
    if (made instanceof FieldValue object) {
      object.heldBy(() -> changed.accept(object.toField()));
    }
    return made;
  }

  private static FieldValue held(FieldValue value, @Nullable Runnable holder) {
    value.heldBy(holder);
    return value;
  }

  private static double[] doubles(Object value) {
    if (value instanceof double[] numbers) {
      return numbers.clone();
    }
    float[] floats = (float[]) value;
    double[] numbers = new double[floats.length];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = floats[i];
    }
    return numbers;
  }

  /**
   * Returns a new tuple without a holder.
   *
   * @param components the components; the array is not copied
   */
  TupleValue tuple(FieldType type, double... components) {
    return placed(type, new TupleValue(type, components));
  }

  private ImageValue image(int[] value) {
    int[] pixels = Arrays.copyOfRange(value, Math.min(3, value.length), value.length);
    boolean whole = value.length >= 3;
    return image(whole ? value[0] : 0, whole ? value[1] : 0, whole ? value[2] : 0, pixels);
  }

  ImageValue image(int width, int height, int comp, int[] pixels) {
    ArrayValue array = placed(FieldType.MFInt32, new ArrayValue(this, FieldType.MFInt32, pixels));
    return placed(FieldType.SFImage, new ImageValue(width, height, comp, array));
  }

  /**
   * Returns the object of a node as the running script sees it: of a prototype instance, the
   * interface.
   */
  public NodeValue node(Node node) {
    return exactly(access().seen(node));
  }

  private NodeAccess access() {
    if (access == null) {
      throw new IllegalStateException("no script is running");
    }
    return access;
  }

  /** Returns the object of the node itself, as seen within the body of a prototype. */
  public NodeValue exactly(Node node) {
    return placed(FieldType.SFNode, new NodeValue(node, this, access()));
  }

  /** Converts a script's value to a copy of that type with a holder of its own. */
  public @Nullable Object adopt(FieldType type, @Nullable Object value, @Nullable Runnable holder) {
    return toScript(type, toField(type, value), holder);
  }

  /** Converts a script's value to the representation of {@link FieldType}. */
  public @Nullable Object toField(FieldType type, @Nullable Object value) {
    if (value instanceof FieldValue own && fits(type, own.type())) {
      return type == own.type() ? own.toField() : converted(type, own);
    }
    if (type.multiple()) {
      return list(type, value);
    }
    return switch (type.kind()) {
      case NODE -> {
        if (value == null || Undefined.isUndefined(value)) {
          yield null;
        }
        if (value instanceof NodeValue node) {
          yield PrototypeInstance.body(node.node());
        }
        throw wrong(type, value);
      }
      case BOOLEAN -> ScriptRuntime.toBoolean(value);
      case STRING -> ScriptRuntime.toString(value);
      case INT -> {
        if (type == FieldType.SFImage) {
          throw wrong(type, value);
        }
        yield (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, number(type, value)));
      }
      case FLOAT -> {
        if (type.components() > 1) {
          yield tuple(type, components(type, value)).toField();
        }
        yield (float) number(type, value);
      }
      case DOUBLE -> {
        if (type.components() > 1) {
          yield tuple(type, components(type, value)).toField();
        }
        yield number(type, value);
      }
    };
  }

  /** Returns whether values of one type can be used for another: the precision may differ. */
  private static boolean fits(FieldType type, FieldType given) {
    return type == given
        || !type.multiple() && !given.multiple() && alike(type, given)
        || type.multiple()
            && given.multiple()
            && (numeric(type) && numeric(given) && type.components() == given.components());
  }

  private static boolean alike(FieldType type, FieldType given) {
    return numeric(type)
        && numeric(given)
        && type.components() == given.components()
        && type.components() > 1
        && (type == FieldType.SFRotation) == (given == FieldType.SFRotation);
  }

  private static boolean numeric(FieldType type) {
    return type.kind() == FieldType.Kind.FLOAT || type.kind() == FieldType.Kind.DOUBLE;
  }

  private Object converted(FieldType type, FieldValue given) {
    if (given instanceof TupleValue tuple) {
      return tuple(type, tuple.components()).toField();
    }
    return list(type, given);
  }

  private Object list(FieldType type, @Nullable Object value) {
    FieldType element = ArrayElements.single(type);
    if (value instanceof NativeArray array) {
      long count = array.getLength();
      if (count > 1 << 24) {
        throw ScriptRuntime.rangeError(type + " cannot have " + count + " elements");
      }
      return ArrayElements.gather(
          type, (int) count, i -> toField(element, ScriptableObject.getProperty(array, i)));
    }
    if (value instanceof ArrayValue many) {
      return ArrayElements.gather(type, many.length(), i -> toField(element, many.get(i, many)));
    }
    if (value instanceof NodeValue && type == FieldType.MFNode) {
      return ArrayElements.gather(type, 1, i -> toField(element, value));
    }
    if (value == null && type == FieldType.MFNode) {
      return type.zero();
    }
    throw wrong(type, value);
  }

  private static double number(FieldType type, @Nullable Object value) {
    if (value instanceof Scriptable) {
      throw wrong(type, value);
    }
    return ScriptRuntime.toNumber(value);
  }

  private static double[] components(FieldType type, @Nullable Object value) {
    if (!(value instanceof NativeArray array) || array.getLength() != type.components()) {
      throw wrong(type, value);
    }
    double[] components = new double[type.components()];
    for (int i = 0; i < components.length; i++) {
      components[i] = ScriptRuntime.toNumber(ScriptableObject.getProperty(array, i));
    }
    return components;
  }

  private static RuntimeException wrong(FieldType type, @Nullable Object value) {
    String given =
        value instanceof Scriptable object
            ? object.getClassName()
            : value == null ? "null" : ScriptRuntime.typeof(value).toString();
    return ScriptRuntime.typeError("a value of type %s is needed, not %s".formatted(type, given));
  }

  /** Formats a script's value as an element of a printed array. */
  String text(FieldType type, @Nullable Object value) {
    if (value instanceof String string) {
      return '"' + string.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
    if (value instanceof Double number) {
      return TupleValue.number(number, type.kind() == FieldType.Kind.FLOAT);
    }
    return value == null ? "NULL" : Context.toString(value);
  }
}
