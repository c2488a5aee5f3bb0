package org.selectiverenderer.browser.script.value;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.IntFunction;
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
   * @param owner what an object belongs to, if the value is an object; null for nothing
   */
  public @Nullable Object toScript(
      FieldType type, @Nullable Object value, @Nullable ValueOwner owner) {
    if (type == FieldType.SFNode) {
      return value == null ? null : node((Node) value);
    }
    if (value == null) {
      return Undefined.instance;
    }
    if (type.multiple()) {
      return owned(array(type, new ElementStorage(type, value)), owner);
    }
    if (type == FieldType.SFImage) {
      return owned(image((int[]) value), owner);
    }
    if (type.components() > 1) {
      return owned(tuple(type, doubles(value)), owner);
    }
    return value instanceof Float number ? (Object) number.doubleValue() : value;
  }

  private static FieldValue owned(FieldValue value, @Nullable ValueOwner owner) {
    value.belongsTo(owner);
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
   * Returns a new tuple without an owner.
   *
   * @param components the components; the array is not copied
   */
  TupleValue tuple(FieldType type, double... components) {
    return placed(type, new TupleValue(type, components));
  }

  /**
   * Returns a new image without an owner.
   *
   * @param value width, height, components and pixels; the array is not copied
   */
  ImageValue image(int[] value) {
    return placed(FieldType.SFImage, new ImageValue(this, value));
  }

  /** Returns a new array without an owner. */
  ArrayValue array(FieldType type, ElementStorage elements) {
    return placed(type, new ArrayValue(this, type, elements));
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

  /** Converts a script's value to a copy of that type with an owner of its own. */
  public @Nullable Object adopt(
      FieldType type, @Nullable Object value, @Nullable ValueOwner owner) {
    return toScript(type, toField(type, value), owner);
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
    if (value instanceof NativeArray array) {
      long count = Math.min(array.getLength(), 1 + ElementStorage.MAX_LENGTH); // Or it refuses.
      return gathered(type, (int) count, i -> ScriptableObject.getProperty(array, i));
    }
    if (value instanceof ArrayValue many) {
      return gathered(type, many.length(), many::peek);
    }
    if (value instanceof NodeValue && type == FieldType.MFNode) {
      return gathered(type, 1, i -> value);
    }
    if (value == null && type == FieldType.MFNode) {
      return type.zero();
    }
    throw wrong(type, value);
  }

  private Object gathered(FieldType type, int count, IntFunction<@Nullable Object> elements) {
    FieldType element = ElementStorage.single(type);
    return ElementStorage.of(type, count, i -> toField(element, elements.apply(i))).value();
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
