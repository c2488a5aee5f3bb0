package org.selectiverenderer.browser.script;

import java.util.function.LongSupplier;

/**
 * The limits of one call of a script.
 *
 * @param callSeconds the time of a call
 * @param startSeconds the time of the first statements and {@code initialize} together
 * @param bytes the memory that a call may allocate
 * @param clock the clock that measures calls, in nanoseconds; its origin does not matter
 */
record ScriptLimits(double callSeconds, double startSeconds, long bytes, LongSupplier clock) {
  /**
   * A call may allocate one part in this number of the heap, so that a scene survives a script that
   * allocates too much.
   */
  private static final int SHARE = 4;

  /** Creates limits that the clock of the machine measures. */
  ScriptLimits(double callSeconds, double startSeconds, long bytes) {
    this(callSeconds, startSeconds, bytes, System::nanoTime);
  }

  /** Returns the limits that docs/scripts.md tells. */
  static ScriptLimits standard() {
    return new ScriptLimits(1, 5, Runtime.getRuntime().maxMemory() / SHARE);
  }
}
