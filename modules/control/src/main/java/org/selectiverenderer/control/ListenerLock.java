package org.selectiverenderer.control;

/**
 * A lock that runs the listeners of a controller one at a time, whichever thread calls them: Xj3D
 * has two threads that deliver field events and a third for browser events. Calls after the end of
 * the scene's control are ignored.
 */
final class ListenerLock {
  private final Object lock;
  private boolean over;

  /**
   * Makes the lock of one scene.
   *
   * @param lock the monitor that all scenes of the controller share
   */
  ListenerLock(Object lock) {
    this.lock = lock;
  }

  /** Runs work under the lock, unless the control has ended. */
  void take(Runnable work) {
    synchronized (lock) {
      if (!over) {
        work.run();
      }
    }
  }

  /** Ends the control: later work is ignored. */
  void end() {
    synchronized (lock) {
      over = true;
    }
  }
}
