package org.selectiverenderer.tracker.live;

/**
 * Whether the process is ending, as by Ctrl-C. Libraries close their devices then, while trackers
 * still read them; that is no fault of the device.
 */
final class ProcessEnd {
  private ProcessEnd() {}

  /** Java tells it only by refusing a hook. */
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
