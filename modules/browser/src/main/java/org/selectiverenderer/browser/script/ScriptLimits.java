package org.selectiverenderer.browser.script;

/**
 * The limits of one call of a script.
 *
 * @param callSeconds the time of a call
 * @param startSeconds the time of the first statements and {@code initialize} together
 * @param bytes the memory that a call may allocate
 */
record ScriptLimits(double callSeconds, double startSeconds, long bytes) {
  /**
   * A call may allocate one part in this number of the heap, so that a scene survives a script that
   * allocates too much.
   */
  private static final int SHARE = 4;

  /** Returns the limits that docs/scripts.md tells. */
  static ScriptLimits standard() {
    return new ScriptLimits(1, 5, Runtime.getRuntime().maxMemory() / SHARE);
  }
}
