package org.selectiverenderer.enricher.task;

import java.util.concurrent.Future;
import org.jspecify.annotations.Nullable;

/** Work in the background, as its bar shows it. Safe for use by several threads. */
public final class Task implements TaskProgress {
  private final String name;
  private final long begun;
  private final boolean stoppable;
  private volatile double fraction = -1;
  private volatile boolean cancelled;
  private volatile @Nullable Future<?> running;

  Task(String name, long begun, boolean stoppable) {
    this.name = name;
    this.stoppable = stoppable;
    this.begun = begun;
  }

  /** What it does, as the author is told: {@code Counting polygons}. */
  public String name() {
    return name;
  }

  /** When it began, as {@link System#nanoTime} counts. */
  public long begun() {
    return begun;
  }

  /** How much is done, from 0 to 1; negative while that is not known. */
  public double fraction() {
    return fraction;
  }

  @Override
  public void done(double newFraction) {
    fraction = newFraction;
  }

  /** Whether {@link #cancel} ends it. */
  public boolean stoppable() {
    return stoppable;
  }

  @Override
  public boolean cancelled() {
    return cancelled;
  }

  /** Ends it as soon as it can be ended; nobody hears of its result. */
  public void cancel() {
    if (!stoppable) {
      return;
    }
    cancelled = true;
    Future<?> future = running;
    if (future != null) {
      future.cancel(true);
    }
  }

  void runs(Future<?> future) {
    running = future;
    if (cancelled) {
      future.cancel(true);
    }
  }
}
