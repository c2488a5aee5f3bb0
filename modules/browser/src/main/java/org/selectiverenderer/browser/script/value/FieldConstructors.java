package org.selectiverenderer.browser.script.value;

import java.util.Arrays;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.LambdaConstructor;
import org.mozilla.javascript.NativeArray;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * Defines the constructors {@code SFVec3f}, {@code MFString} ... in a scope (ISO/IEC 19777-1, 7;
 * VRML97, C.6).
 */
public final class FieldConstructors {
  /** Aliases that VRML97 and older scripts use. */
  private static final Map<String, FieldType> OTHER_NAMES =
      Map.of(
          "VrmlMatrix", FieldType.SFMatrix4f,
          "X3DMatrix3", FieldType.SFMatrix3f,
          "X3DMatrix4", FieldType.SFMatrix4f);

  private final Scriptable scope;
  private final FieldValueConverter values;

  private FieldConstructors(Scriptable scope, FieldValueConverter values) {
    this.scope = scope;
    this.values = values;
  }

  /** Defines all constructors. */
  public static void define(ScriptableObject scope, FieldValueConverter values) {
    FieldConstructors constructors = new FieldConstructors(scope, values);
    for (FieldType type : FieldType.values()) {
      if (type.multiple()) {
        constructors.array(scope, type);
      } else if (type == FieldType.SFImage) {
        constructors.image(scope);
      } else if (type == FieldType.SFNode) {
        constructors.node(scope);
      } else if (type.components() > 1) {
        constructors.tuple(scope, type);
      }
    }
    OTHER_NAMES.forEach(
        (name, type) ->
            ScriptableObject.defineProperty(
                scope,
                name,
                ScriptableObject.getProperty(scope, type.name()),
                ScriptableObject.DONTENUM));
  }

  private void publish(ScriptableObject into, FieldType type, LambdaConstructor constructor) {
    CommonValueMethods.define(scope, constructor);
    ScriptableObject.defineProperty(into, type.name(), constructor, ScriptableObject.DONTENUM);
    values.prototype(type, (Scriptable) constructor.getPrototypeProperty());
  }

  private void array(ScriptableObject into, FieldType type) {
    LambdaConstructor constructor =
        new LambdaConstructor(scope, type.name(), 0, (cx, from, args) -> array(type, args));
    Scriptable prototype = (Scriptable) constructor.getPrototypeProperty();
    publish(into, type, constructor);
    // Array methods such as push, slice and map work on all objects with a length; toString is its
    // own.
    prototype.setPrototype(ScriptableObject.getArrayPrototype(scope));
  }

  private Scriptable array(FieldType type, Object[] args) {
    boolean list = args.length == 1 && (args[0] instanceof NativeArray || isSame(type, args[0]));
    if (list) {
      return (Scriptable) values.adopt(type, args[0], null);
    }
    FieldType element = ElementStorage.single(type);
    return values.array(
        type, ElementStorage.of(type, args.length, i -> values.toField(element, args[i])));
  }

  private static boolean isSame(FieldType type, Object argument) {
    return argument instanceof ArrayValue many && many.type() == type;
  }

  private void image(ScriptableObject into) {
    publish(
        into,
        FieldType.SFImage,
        new LambdaConstructor(
            scope,
            "SFImage",
            4,
            (cx, from, args) -> {
              if (args.length < 4) {
                return values.image(new int[3]);
              }
              ImageValue image =
                  values.image(
                      new int[] {
                        Math.max(0, ScriptRuntime.toInt32(args[0])),
                        Math.max(0, ScriptRuntime.toInt32(args[1])),
                        Math.max(0, Math.min(4, ScriptRuntime.toInt32(args[2])))
                      });
              image.put("array", image, args[3]);
              return image;
            }));
  }

  /** Defines {@code new SFNode(text)}, which returns the first node of a scene given as text. */
  private void node(ScriptableObject into) {
    publish(
        into,
        FieldType.SFNode,
        new LambdaConstructor(
            scope,
            "SFNode",
            1,
            (cx, from, args) -> {
              Object browser = ScriptableObject.getProperty(scope, "Browser");
              Object scene =
                  ScriptableObject.callMethod(
                      cx, (Scriptable) browser, "createVrmlFromString", args);
              Object first = ScriptableObject.getProperty((Scriptable) scene, 0);
              if (first instanceof NodeValue node) {
                return node;
              }
              throw ScriptRuntime.typeError("the text of new SFNode holds no node");
            }));
  }

  private void tuple(ScriptableObject into, FieldType type) {
    LambdaConstructor constructor =
        new LambdaConstructor(
            scope,
            type.name(),
            type.components(),
            (cx, from, args) -> values.tuple(type, components(type, args)));
    new TupleMethods(scope, values, type).define(constructor);
    publish(into, type, constructor);
  }

  private double[] components(FieldType type, Object[] args) {
    if (args.length == 1 && (args[0] instanceof TupleValue || args[0] instanceof NativeArray)) {
      return tuple(values.adopt(type, args[0], null)).components();
    }
    if (type == FieldType.SFRotation && args.length >= 2 && args[0] instanceof TupleValue axis) {
      return args[1] instanceof TupleValue to
          ? VectorMath.between(axis.components(), to.components())
          : VectorMath.rotation(axis.components(), ScriptRuntime.toNumber(args[1]));
    }
    double[] components = identity(type);
    for (int i = 0; i < Math.min(args.length, components.length); i++) {
      if (args[i] instanceof Scriptable || Undefined.isUndefined(args[i])) {
        throw ScriptRuntime.typeError("new %s needs %s numbers".formatted(type, type.components()));
      }
      components[i] = ScriptRuntime.toNumber(args[i]);
    }
    return components;
  }

  /**
   * Returns the value of a constructor without arguments: zero, no rotation, the identity matrix.
   */
  private static double[] identity(FieldType type) {
    double[] components = new double[type.components()];
    int size =
        switch (type) {
          case SFMatrix3f, SFMatrix3d -> 3;
          case SFMatrix4f, SFMatrix4d -> 4;
          default -> 0;
        };
    for (int i = 0; i < size; i++) {
      components[i * size + i] = 1;
    }
    if (type == FieldType.SFRotation) {
      components[2] = 1;
    } else if (type == FieldType.SFColorRGBA) {
      Arrays.fill(components, 3, 4, 1);
    }
    return components;
  }

  /** Casts an argument to a tuple, or throws a TypeError. */
  static TupleValue tuple(@Nullable Object argument) {
    if (argument instanceof TupleValue tuple) {
      return tuple;
    }
    throw ScriptRuntime.typeError("an argument must be a vector, colour, rotation or matrix");
  }
}
