package org.selectiverenderer.enricher.task;

import java.util.concurrent.CancellationException;

/** Reports the progress of background work, and tells the work whether it is cancelled. */
public interface TaskProgress {
  /**
   * Reports the progress.
   *
   * @param fraction from 0 to 1
   */
  void done(double fraction);

  /** Whether the task is cancelled. */
  boolean cancelled();

  /**
   * Throws if the task is cancelled; for the inside of loops.
   *
   * @throws CancellationException if it is cancelled
   */
  default void check() {
    if (cancelled()) {
      throw new CancellationException();
    }
  }
}
