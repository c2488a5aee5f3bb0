package org.selectiverenderer.render.context;

import com.jogamp.nativewindow.NativeWindowFactory;

/**
 * Registers actions that run before JOGL's shutdown hook. When the process is terminated from
 * outside, that hook destroys all windows and contexts even while a thread still draws.
 */
public final class GlShutdownHook {
  private GlShutdownHook() {}

  /**
   * Runs an action before JOGL destroys its windows and contexts.
   *
   * @param ending waits until no thread draws; called once, on another thread. To be registered
   *     when a window exists, even if it is not shown yet, or when the context is open: JOGL's
   *     parts register their own actions when they are first used, and the last one registered runs
   *     first
   */
  public static void before(Runnable ending) {
    NativeWindowFactory.addCustomShutdownHook(true, ending);
  }
}
