package org.selectiverenderer.browser.script;

import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.CompilerEnvirons;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ContextFactory;
import org.mozilla.javascript.ErrorReporter;
import org.mozilla.javascript.Evaluator;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.selectiverenderer.browser.script.value.FieldConstructors;
import org.selectiverenderer.browser.script.value.FieldValueConverter;
import org.selectiverenderer.x3d.script.BigIntLiteralDetector;

/**
 * The Rhino script engine with all that the scripts of a world share. It interprets instead of
 * compiling: a scene's scripts are short, and a script compiled to Java classes takes longer to
 * start than to run, cannot be interrupted as finely, and overflows the stack of the application
 * itself.
 */
final class RhinoEngine {
  /** The deepest nesting of calls. */
  private static final int MAX_DEPTH = 500;

  /** Instructions between two checks of the limits: well below a millisecond. */
  private static final int LOOK_EVERY = 10_000;

  private final ContextFactory factory = new Limited();
  private final CallLimit limit = new CallLimit();
  private final ScriptableObject shared;
  private final FieldValueConverter values;
  private @Nullable RunningScript running;

  RhinoEngine(ScriptScheduler scripts, ScriptHost world) {
    Context context = factory.enterContext();
    try {
      shared = context.initSafeStandardObjects();
      values = new FieldValueConverter(shared);
      FieldConstructors.define(shared, values);
      Map.of("TRUE", true, "FALSE", false).forEach((name, value) -> hidden(name, value));
      hidden("NULL", null);
      hidden("X3DConstants", X3dConstants.of(context, shared));
      NodeObjectMethods.define(shared, () -> world.files().catalogue());
      new BrowserObject(this, scripts, world).define(context, shared);
      SandboxedBuiltIns.define(shared, () -> world.cascade().time());
    } finally {
      Context.exit();
    }
  }

  private void hidden(String name, @Nullable Object value) {
    ScriptableObject.defineProperty(shared, name, value, ScriptableObject.DONTENUM);
  }

  /** Returns the shared scope: the standard objects, constructors and {@code Browser}. */
  ScriptableObject shared() {
    return shared;
  }

  FieldValueConverter values() {
    return values;
  }

  /** Returns the script whose code is running. */
  RunningScript running() {
    if (running == null) {
      throw new IllegalStateException("no script is running");
    }
    return running;
  }

  /**
   * Runs code of a script under the limits of a call.
   *
   * @param seconds the time in seconds after which it is stopped
   */
  <T> T call(RunningScript script, double seconds, Function<Context, T> code) {
    RunningScript before = running;
    Context context = factory.enterContext();
    try {
      running = script;
      values.accessBy(script);
      limit.begin(seconds);
      return code.apply(context);
    } finally {
      running = before;
      values.accessBy(before);
      Context.exit();
    }
  }

  /** A context that rejects sources with BigInt literals, {@code eval} included. */
  private static final class Bounded extends Context {
    Bounded(ContextFactory factory) {
      super(factory);
    }

    @Override
    protected Object compileImpl(
        @Nullable Scriptable scope,
        String source,
        String name,
        int line,
        @Nullable Object domain,
        boolean function,
        @Nullable Evaluator compiler,
        @Nullable ErrorReporter reporter,
        @Nullable Consumer<CompilerEnvirons> settings) {
      BigIntLiteralDetector.line(source)
          .ifPresent(
              found -> {
                throw ScriptRuntime.constructError(
                    "SyntaxError", BigIntLiteralDetector.REFUSED, name, line + found - 1, null, 0);
              });
      return super.compileImpl(
          scope, source, name, line, domain, function, compiler, reporter, settings);
    }
  }

  /** Makes contexts in which a script can neither access Java nor run for ever. */
  private final class Limited extends ContextFactory {
    @Override
    protected Context makeContext() {
      Context context = new Bounded(this);
      context.setInterpretedMode(true);
      context.setLanguageVersion(Context.VERSION_ES6);
      context.setMaximumInterpreterStackDepth(MAX_DEPTH);
      context.setInstructionObserverThreshold(LOOK_EVERY);
      context.setClassShutter(name -> false);
      return context;
    }

    @Override
    protected void observeInstructionCount(Context context, int count) {
      limit.check();
    }
  }
}
