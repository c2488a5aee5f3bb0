package org.selectiverenderer.enricher.task;

import java.util.concurrent.Future;
import org.jspecify.annotations.Nullable;

/** A background task with its name and progress. Thread-safe. */
public final class BackgroundTask implements TaskProgress {
  private final String name;
  private final long begun;
  private final boolean stoppable;
  private final boolean awaited;
  private volatile double fraction = -1;
  private volatile boolean cancelled;
  private boolean over;
  private volatile @Nullable Future<?> running;
  private volatile Runnable ended = () -> {};

  /**
   * @param awaited whether its end is told even when it is cancelled
   */
  BackgroundTask(String name, long begun, boolean stoppable, boolean awaited) {
    this.awaited = awaited;
    this.name = name;
    this.stoppable = stoppable;
    this.begun = begun;
  }

  /** The name as the status bar shows it: {@code Counting polygons}. */
  public String name() {
    return name;
  }

  /** The start time by {@link System#nanoTime}. */
  public long begun() {
    return begun;
  }

  /** The progress from 0 to 1; negative while unknown. */
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

  /** Whether its end is told even when it is cancelled. */
  boolean awaited() {
    return awaited;
  }

  /** Ends the task and returns whether it has been cancelled; from now on it cannot be. */
  synchronized boolean endsCancelled() {
    over = true;
    return cancelled;
  }

  private synchronized boolean becomesCancelled() {
    boolean first = !cancelled && !over;
    cancelled |= first;
    return first;
  }

  /** Cancels the task as soon as possible; its result is dropped. */
  public void cancel() {
    if (!stoppable) {
      return;
    }
    if (becomesCancelled()) {
      ended.run();
    }
    Future<?> future = running;
    if (future != null) {
      future.cancel(true);
    }
  }

  /**
   * Sets what runs when the task is cancelled, as its result is dropped then.
   *
   * @param work runs on the thread that cancels, which for the author's button is the event
   *     dispatch thread
   */
  public void onCancel(Runnable work) {
    ended = work;
  }

  void runs(Future<?> future) {
    running = future;
    if (cancelled) {
      future.cancel(true);
    }
  }
}
