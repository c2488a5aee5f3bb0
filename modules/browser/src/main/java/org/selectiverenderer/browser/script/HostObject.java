package org.selectiverenderer.browser.script;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.LambdaFunction;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;

/** A host object: an object of the browser with methods and properties for scripts. */
@SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
class HostObject extends ScriptableObject {
  /** The body of a method; null stands for no result. */
  @FunctionalInterface
  interface Method {
    @Nullable Object call(Object[] args);
  }

  private final String name;

  HostObject(String name, Scriptable scope) {
    super(scope, ScriptableObject.getObjectPrototype(scope));
    this.name = name;
  }

  @Override
  public String getClassName() {
    return name;
  }

  @Override
  public Object getDefaultValue(@Nullable Class<?> hint) {
    return name;
  }

  /**
   * @param least the least number of arguments
   */
  final void method(String method, int least, Method body) {
    LambdaFunction function =
        new LambdaFunction(
            getParentScope(),
            method,
            least,
            (cx, from, self, args) -> {
              if (args.length < least) {
                throw ScriptRuntime.typeError(
                    "%s of %s needs %s arguments, not %s"
                        .formatted(method, name, least, args.length));
              }
              return body.call(args);
            });
    defineProperty(method, function, DONTENUM);
  }

  /** Defines a method without a result. */
  final void action(String method, int least, Consumer<Object[]> body) {
    method(
        method,
        least,
        args -> {
          body.accept(args);
          return Undefined.instance;
        });
  }

  /** Defines a read-only property. */
  final void property(String property, Supplier<@Nullable Object> value) {
    defineProperty(property, value::get, null, DONTENUM);
  }

  /** Defines a writable property. */
  final void property(
      String property, Supplier<@Nullable Object> value, Consumer<Object> assigned) {
    defineProperty(property, value::get, assigned::accept, DONTENUM);
  }

  /** Converts an argument to a string. */
  static String text(Object argument) {
    return ScriptRuntime.toString(argument);
  }
}
