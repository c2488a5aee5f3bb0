package org.selectiverenderer.scriptengine;

import java.util.Collection;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ScriptRuntime;

/**
 * Meters the work and memory of the script that the calling thread runs. The build inserts calls of
 * these methods into Rhino; objects of the browser call them in loops of their own.
 */
public final class ScriptMeter {
  /** The message about BigInt. */
  public static final String NO_BIG_INTEGERS =
      "integers of any length, such as 2n, are not supported";

  /** Allocations below this size in bytes are seen afterwards, by the count of the thread. */
  private static final int SMALL = 1 << 14;

  private ScriptMeter() {}

  /** Counts one unit of work: a round of a loop, a call. */
  public static void tick() {
    if (Context.getCurrentContext() instanceof MeteredContext context) {
      context.work(1);
    }
  }

  /** Counts units of work, each of some nanoseconds, before they are done. */
  public static void work(long units) {
    if (Context.getCurrentContext() instanceof MeteredContext context) {
      context.work(units);
    }
  }

  /** Counts the work of the virtual machine on so many characters or elements at once. */
  static void bulk(int count) {
    if (count > 512) {
      work(count >> 5);
    }
  }

  /** Checks memory that is about to be allocated. */
  public static void allocate(int count, int bytesEach) {
    long bytes = (long) count * bytesEach;
    if (bytes >= SMALL && Context.getCurrentContext() instanceof MeteredContext context) {
      context.checkLimits(bytes);
      context.work(bytes >> 8);
    }
  }

  /** Checks the memory of a collection that is given room. */
  public static void allocateReferences(int count) {
    allocate(count, 8);
  }

  /** Checks the memory of a text that is given room. */
  public static void allocateCharacters(int count) {
    allocate(count, 2);
  }

  /** Checks the memory for a copy of a text, an array or a collection. */
  public static void copy(@Nullable Object original) {
    if (original instanceof CharSequence text) {
      allocateCharacters(text.length());
    } else if (original instanceof char[] text) {
      allocateCharacters(text.length);
    } else if (original instanceof Collection<?> all) {
      allocateReferences(all.size());
    } else if (original instanceof Map<?, ?> all) {
      allocate(all.size(), 48);
    }
  }

  /** Begins a nested run of the interpreter. */
  public static void beginNested() {
    if (Context.getCurrentContext() instanceof MeteredContext context) {
      context.beginNested();
    }
  }

  /** Ends a nested run of the interpreter. */
  public static void endNested() {
    if (Context.getCurrentContext() instanceof MeteredContext context) {
      context.endNested();
    }
  }

  /**
   * Refuses an operation on integers of any length, one of which could take hours.
   *
   * @throws org.mozilla.javascript.EcmaError always
   */
  public static void refuseBigInteger() {
    throw ScriptRuntime.typeError(NO_BIG_INTEGERS);
  }
}
