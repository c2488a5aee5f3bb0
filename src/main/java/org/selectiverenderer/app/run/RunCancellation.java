package org.selectiverenderer.app.run;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.selectiverenderer.render.context.GlShutdownHook;

/** Asks a run to end after its present frame, as when its window is closed; from any thread. */
public final class RunCancellation {
  /**
   * How long JOGL waits for a picture in progress. Commands end the process before, since it
   * crashes with pages of messages when JOGL takes away what a driver is still drawing to.
   */
  private static final long PATIENCE_MS = 8000;

  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile boolean asked;

  /** Asks the run to end after its present frame, or as soon as it begins. */
  public void stop() {
    asked = true;
  }

  /**
   * Registers with JOGL's shutdown, once the window exists or the context is open, so that the run
   * ends first when the process is ended.
   */
  void drawing() {
    GlShutdownHook.before(this::stopAndWait);
  }

  /** Returns whether the run was asked to end. */
  boolean asked() {
    return asked;
  }

  /** Reports that nothing is drawn any more. */
  void ended() {
    ended.countDown();
  }

  /** Ends the run and waits until nothing is drawn any more, or for some seconds. */
  private void stopAndWait() {
    stop();
    try {
      ended.await(PATIENCE_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
