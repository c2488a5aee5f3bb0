package org.selectiverenderer.app.clock;

import java.util.function.LongSupplier;

/** Seconds of the clock on the wall that a run takes, pauses not counted. */
public final class Stopwatch {
  private final LongSupplier nanos;
  private long begun;
  private long now;
  private long stood;
  private boolean going;

  public Stopwatch() {
    this(System::nanoTime);
  }

  /**
   * @param nanos of another clock
   */
  public Stopwatch(LongSupplier nanos) {
    this.nanos = nanos;
  }

  /**
   * A frame begins; the first one begins the run.
   *
   * @param paused whether the time since the frame before does not count
   */
  public void tick(boolean paused) {
    long last = now;
    now = nanos.getAsLong();
    if (!going) {
      going = true;
      begun = now;
    } else if (paused) {
      begun += now - last;
      stood += now - last;
    }
  }

  /** What has gone by does not count. */
  public void restart() {
    now = nanos.getAsLong();
    begun = now;
  }

  /** What its clock said at the last frame, in nanoseconds; that clock goes on in pauses. */
  public long nanos() {
    return now;
  }

  /** How long it was paused in all, in nanoseconds. */
  public long paused() {
    return stood;
  }

  /** As of the last frame; 0 before the first. */
  public double seconds() {
    return (now - begun) * 1e-9;
  }
}
