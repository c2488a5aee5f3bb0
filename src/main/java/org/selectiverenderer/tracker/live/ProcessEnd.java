package org.selectiverenderer.tracker.live;

/**
 * Detects the shutdown of the process, as by Ctrl-C. Libraries then close their devices while
 * trackers still read them, which is not a failure of the device.
 */
final class ProcessEnd {
  private ProcessEnd() {}

  /**
   * Returns whether the shutdown has begun. Java has no query for it, but rejects new shutdown
   * hooks.
   */
  static boolean begun() {
    Thread hook = new Thread(() -> {});
    try {
      Runtime.getRuntime().addShutdownHook(hook);
      return !Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      return true;
    }
  }
}
