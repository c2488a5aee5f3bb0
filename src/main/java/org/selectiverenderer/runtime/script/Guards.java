package org.selectiverenderer.runtime.script;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleSupplier;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.Function;
import org.mozilla.javascript.LambdaFunction;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;

/**
 * What of ECMAScript's own objects is different in a scene. Time is the scene's, and chance is the
 * same in every run, so that the same walk gives the same events. What Rhino does in one go, where
 * the limits of a call cannot reach it, is kept to a bearable size.
 */
final class Guards {
  /** Elements or characters that one function of the standard objects may work on. */
  private static final int MAX_LENGTH = 1 << 22;

  /** Buffers of numbers, which scripts of scenes have no use for, and integers of any length. */
  private static final List<String> LEFT_OUT =
      List.of(
          "ArrayBuffer",
          "DataView",
          "Int8Array",
          "Uint8Array",
          "Uint8ClampedArray",
          "Int16Array",
          "Uint16Array",
          "Int32Array",
          "Uint32Array",
          "Float32Array",
          "Float64Array",
          "BigInt64Array",
          "BigUint64Array",
          "BigInt");

  private Guards() {}

  /**
   * @param time the scene's, in seconds since 1970
   */
  static void define(ScriptableObject scope, DoubleSupplier time) {
    LEFT_OUT.forEach(scope::delete);
    bound(scope, ScriptableObject.getClassPrototype(scope, "Array"));
    bound(scope, ScriptableObject.getClassPrototype(scope, "String"));
    bound(scope, (Scriptable) ScriptableObject.getProperty(scope, "Array"));
    Random random = new Random(0);
    replace(
        scope,
        (ScriptableObject) ScriptableObject.getProperty(scope, "Math"),
        "random",
        0,
        args -> random.nextDouble());
    date(scope, time);
  }

  /** What a replaced function does. */
  @FunctionalInterface
  private interface Body {
    Object call(Object[] args);
  }

  private static void replace(
      Scriptable scope, ScriptableObject owner, String name, int count, Body body) {
    owner.defineProperty(
        name,
        new LambdaFunction(scope, name, count, (cx, from, self, args) -> body.call(args)),
        ScriptableObject.DONTENUM);
  }

  /** Has each method look at the length of what it is called on, and at its numbers, first. */
  private static void bound(Scriptable scope, Scriptable owner) {
    ScriptableObject object = (ScriptableObject) owner;
    for (Object id : object.getAllIds()) {
      if (id instanceof String name
          && !name.equals("constructor")
          && !name.equals("prototype")
          && object.get(name, object) instanceof Function method) {
        LambdaFunction bounded =
            new LambdaFunction(
                scope,
                name,
                0,
                (cx, from, self, args) -> {
                  check(name, self, args);
                  return method.call(cx, from, self, args);
                });
        object.defineProperty(name, bounded, ScriptableObject.DONTENUM);
      }
    }
  }

  private static void check(String name, Object self, Object[] args) {
    double length = length(self);
    switch (name) {
      case "repeat" -> length *= args.length > 0 ? ScriptRuntime.toNumber(args[0]) : 0;
      case "padStart", "padEnd" -> length = args.length > 0 ? ScriptRuntime.toNumber(args[0]) : 0;
      case "from" -> length = args.length > 0 ? length(args[0]) : 0;
      default -> {
        // All others go through what they are called on.
      }
    }
    if (length > MAX_LENGTH) {
      throw ScriptRuntime.rangeError(
          "%s of more than %s elements or characters is too much".formatted(name, MAX_LENGTH));
    }
  }

  private static double length(Object object) {
    if (object instanceof CharSequence text) {
      return text.length();
    }
    if (object instanceof Scriptable list && !(object instanceof Function)) {
      Object length = ScriptableObject.getProperty(list, "length");
      return length instanceof Number number ? number.doubleValue() : 0;
    }
    return 0;
  }

  /** {@code new Date()} and {@code Date.now()} give the scene's time. */
  private static void date(ScriptableObject scope, DoubleSupplier time) {
    Function original = (Function) ScriptableObject.getProperty(scope, "Date");
    SceneDate date = new SceneDate(scope, original, time);
    for (Object id : ((ScriptableObject) original).getAllIds()) {
      if (id instanceof String name && !date.has(name, date)) {
        date.defineProperty(name, original.get(name, original), ScriptableObject.DONTENUM);
      }
    }
    Scriptable prototype = (Scriptable) original.get("prototype", original);
    date.setPrototypeProperty(prototype);
    replace(scope, date, "now", 0, args -> Math.floor(time.getAsDouble() * 1000));
    prototype.put("constructor", prototype, date);
    ScriptableObject.defineProperty(scope, "Date", date, ScriptableObject.DONTENUM);
  }

  /** A Date whose now is the scene's. */
  @SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
  private static final class SceneDate extends LambdaFunction {
    private final transient Function original;
    private final transient DoubleSupplier time;

    SceneDate(Scriptable scope, Function original, DoubleSupplier time) {
      super(
          scope,
          "Date",
          7,
          (cx, from, self, args) ->
              ScriptRuntime.toString(
                  original.construct(cx, from, new Object[] {time.getAsDouble() * 1000})));
      this.original = original;
      this.time = time;
    }

    void setPrototypeProperty(Scriptable prototype) {
      setImmunePrototypeProperty(prototype);
    }

    @Override
    public Scriptable construct(Context cx, Scriptable from, Object[] args) {
      boolean now = args.length == 0 || Undefined.isUndefined(args[0]) && args.length == 1;
      Object[] given = now ? new Object[] {Math.floor(time.getAsDouble() * 1000)} : args;
      return original.construct(cx, from, given);
    }
  }
}
