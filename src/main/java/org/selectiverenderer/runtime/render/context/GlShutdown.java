package org.selectiverenderer.runtime.render.context;

import com.jogamp.nativewindow.NativeWindowFactory;

/**
 * When the process is ended from outside, JOGL lets go of all windows and contexts in a hook of its
 * own, under whoever still draws. Here one can be heard before.
 */
public final class GlShutdown {
  private GlShutdown() {}

  /**
   * Has something done before JOGL lets go.
   *
   * @param ending waits until nobody draws; called once, on another thread. Given when the window
   *     or the context is open: JOGL's parts add themselves as they are first used, and the last
   *     one is heard first
   */
  public static void before(Runnable ending) {
    NativeWindowFactory.addCustomShutdownHook(true, ending);
  }
}
