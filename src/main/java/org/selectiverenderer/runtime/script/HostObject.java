package org.selectiverenderer.runtime.script;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.LambdaFunction;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;

/** An object of the browser as scripts see it: methods and properties. */
@SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
class HostObject extends ScriptableObject {
  /** What a method does; null stands for nothing to give back. */
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
   * @param least arguments that it needs
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

  /** A method that gives nothing back. */
  final void action(String method, int least, Consumer<Object[]> body) {
    method(
        method,
        least,
        args -> {
          body.accept(args);
          return Undefined.instance;
        });
  }

  /** A property that scripts read. */
  final void property(String property, Supplier<@Nullable Object> value) {
    defineProperty(property, value::get, null, DONTENUM);
  }

  /** A property that scripts read and write. */
  final void property(
      String property, Supplier<@Nullable Object> value, Consumer<Object> assigned) {
    defineProperty(property, value::get, assigned::accept, DONTENUM);
  }

  /** An argument as text. */
  static String text(Object argument) {
    return ScriptRuntime.toString(argument);
  }
}
