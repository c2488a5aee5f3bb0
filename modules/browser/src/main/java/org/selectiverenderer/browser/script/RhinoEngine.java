package org.selectiverenderer.browser.script;

import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ContextFactory;
import org.mozilla.javascript.ScriptableObject;
import org.selectiverenderer.browser.script.value.FieldConstructors;
import org.selectiverenderer.browser.script.value.FieldValueConverter;
import org.selectiverenderer.scriptengine.LanguageExtensions;
import org.selectiverenderer.scriptengine.MeteredContext;

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

  private final ContextFactory factory = new Factory();
  private final ScriptLimits limits;
  private final CallLimit limit;
  private final ScriptableObject shared;
  private final FieldValueConverter values;
  private @Nullable RunningScript running;

  RhinoEngine(ScriptScheduler scripts, ScriptHost world, ScriptLimits limits) {
    if (!MeteredContext.engineIsMetered()) {
      throw new IllegalStateException(
          "Scripts cannot run: the class path has Rhino as published before the program's own,"
              + " metered copy of it; remove that jar");
    }
    this.limits = limits;
    limit = new CallLimit(limits.bytes(), limits.clock());
    Context context = factory.enterContext();
    try {
      shared = context.initSafeStandardObjects();
      LanguageExtensions.define(shared);
      values = new FieldValueConverter(shared);
      FieldConstructors.define(shared, values);
      Map.of("TRUE", true, "FALSE", false).forEach((name, value) -> hidden(name, value));
      hidden("NULL", null);
      hidden("X3DConstants", X3dConstants.of(context, shared));
      NodeObjectMethods.define(
          shared, () -> world.files().catalogue(), () -> running().nodes().complete());
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
   * Runs code of a script, and what its promises then do, under the limits of a call. A call within
   * a call is under those of the outer one.
   *
   * @param starting whether these are the script's first statements, which have more time
   */
  <T> T call(RunningScript script, boolean starting, Function<Context, T> code) {
    RunningScript before = running;
    Context context = factory.enterContext();
    try {
      running = script;
      values.accessBy(script.nodes());
      if (before == null) {
        limit.begin(starting ? limits.startSeconds() : limits.callSeconds());
      }
      T result = code.apply(context);
      if (before == null) {
        context.processMicrotasks(); // What promises have scheduled belongs to the call.
        limit.end();
      }
      return result;
    } finally {
      running = before;
      values.accessBy(before == null ? null : before.nodes());
      Context.exit();
    }
  }

  /** The context of scripts, which is under the limit of the running call. */
  private final class Limited extends MeteredContext {
    Limited(ContextFactory factory) {
      super(factory);
    }

    @Override
    protected void checkLimits(long bytes) {
      if (running != null) {
        limit.check(bytes);
      }
    }
  }

  /** Makes contexts in which a script can neither access Java nor run for ever. */
  private final class Factory extends ContextFactory {
    @Override
    protected Context makeContext() {
      Context context = new Limited(this);
      context.setInterpretedMode(true);
      context.setLanguageVersion(Context.VERSION_ES6);
      context.setMaximumInterpreterStackDepth(MAX_DEPTH);
      context.setInstructionObserverThreshold(LOOK_EVERY);
      context.setClassShutter(name -> false);
      return context;
    }

    @Override
    protected void observeInstructionCount(Context context, int count) {
      limit.check(0);
    }
  }
}
