package org.selectiverenderer.control;

/**
 * Lets listeners of a controller work one at a time, whichever thread calls them: Xj3D has two that
 * deliver events of fields and a third for those of the browser. What arrives after the control
 * over the scene has ended is passed over.
 */
final class Turn {
  private final Object lock;
  private boolean over;

  /**
   * A turn of one scene.
   *
   * @param lock shared by all that may not happen at once
   */
  Turn(Object lock) {
    this.lock = lock;
  }

  /** Works when nobody else does, unless it is over. */
  void take(Runnable work) {
    synchronized (lock) {
      if (!over) {
        work.run();
      }
    }
  }

  /** Nothing happens any more. */
  void end() {
    synchronized (lock) {
      over = true;
    }
  }
}
