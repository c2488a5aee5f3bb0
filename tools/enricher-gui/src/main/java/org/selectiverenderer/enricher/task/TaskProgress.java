package org.selectiverenderer.enricher.task;

import java.util.concurrent.CancellationException;

/** What work in the background may say of itself, and hears. */
public interface TaskProgress {
  /**
   * How much is done.
   *
   * @param fraction from 0 to 1
   */
  void done(double fraction);

  /** Whether the author wants it no more. */
  boolean cancelled();

  /**
   * Ends cancelled work; for the inside of loops.
   *
   * @throws CancellationException if it is cancelled
   */
  default void check() {
    if (cancelled()) {
      throw new CancellationException();
    }
  }
}
