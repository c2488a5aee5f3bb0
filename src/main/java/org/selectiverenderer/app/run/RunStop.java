package org.selectiverenderer.app.run;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.runtime.render.context.GlShutdown;

/** Asks a run to end after its present frame, as when its window is closed; from any thread. */
public final class RunStop {
  private static final long PATIENCE_MS = 2000;

  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile boolean asked;

  /** Ends the run soon, or as soon as it begins. */
  public void stop() {
    asked = true;
  }

  /**
   * The window or the context is open: should the process be ended, JOGL lets the run end first.
   */
  void drawing() {
    GlShutdown.before(this::stopAndWait);
  }

  /** Whether it is to end. */
  boolean asked() {
    return asked;
  }

  /** Nothing is drawn any more. */
  void ended() {
    ended.countDown();
  }

  /** Ends the run and waits until nothing is drawn any more, or for two seconds. */
  private void stopAndWait() {
    stop();
    try {
      ended.await(PATIENCE_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
