package org.selectiverenderer.scriptengine;

import org.mozilla.javascript.Context;
import org.mozilla.javascript.ContextFactory;
import org.mozilla.javascript.ScriptRuntime;

/** A context whose scripts are metered in all that they do, inside of built-in functions too. */
public abstract class MeteredContext extends Context {
  /** The units of work between two checks: some tens of microseconds. */
  private static final int UNITS_PER_CHECK = 4096;

  /**
   * The deepest nesting of scripts within built-in functions within scripts, such as a function
   * that maps an array by itself. Each level takes about 1 KB of the thread's stack. A stack that
   * overflows within the initialisation of a class makes that class unusable for good.
   */
  private static final int MAX_DEPTH = 150;

  private int units = UNITS_PER_CHECK;
  private int depth;

  protected MeteredContext(ContextFactory factory) {
    super(factory);
  }

  /**
   * Checks the limits of the running script.
   *
   * @param bytes the memory that is about to be allocated
   * @throws Error if a limit is exceeded; scripts cannot catch errors
   */
  protected abstract void checkLimits(long bytes);

  /**
   * Returns whether the engine on the class path is the metered one. If Rhino as published comes
   * first there, no script may run.
   */
  public static boolean engineIsMetered() {
    return Metered.class.isAssignableFrom(Context.class);
  }

  final void work(long done) {
    if (done >= units) {
      units = UNITS_PER_CHECK;
      checkLimits(0);
    } else {
      units -= (int) done;
    }
  }

  final void beginNested() {
    work(1);
    if (depth >= MAX_DEPTH) {
      throw ScriptRuntime.rangeError("calls are nested too deeply");
    }
    depth++;
  }

  final void endNested() {
    depth--;
  }
}
