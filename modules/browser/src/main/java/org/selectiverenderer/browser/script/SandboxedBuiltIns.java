package org.selectiverenderer.browser.script;

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
 * Replaces some of ECMAScript's built-in objects for scripts of a scene. Dates come from the
 * scene's time, and random numbers are the same in every run, so that the same walk gives the same
 * events.
 */
final class SandboxedBuiltIns {
  /** Removed: typed arrays, for which scripts of scenes have no use, and BigInt. */
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

  private SandboxedBuiltIns() {}

  /**
   * @param time the scene's time in seconds since 1970
   */
  static void define(ScriptableObject scope, DoubleSupplier time) {
    LEFT_OUT.forEach(scope::delete);
    Random random = new Random(0);
    replace(
        scope,
        (ScriptableObject) ScriptableObject.getProperty(scope, "Math"),
        "random",
        0,
        args -> random.nextDouble());
    date(scope, time);
  }

  /** The body of a replaced function. */
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

  /** Makes {@code new Date()} and {@code Date.now()} return the scene's time. */
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

  /** The Date constructor with the scene's time. */
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
