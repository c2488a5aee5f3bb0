package org.selectiverenderer.app.clock;

import java.util.function.LongSupplier;

/** Measures the real time of a run without its pauses. */
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
   * @param nanos a clock in nanoseconds instead of {@link System#nanoTime}
   */
  public Stopwatch(LongSupplier nanos) {
    this.nanos = nanos;
  }

  /**
   * Reports that a frame begins; the first frame starts the stopwatch.
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

  /** Sets the elapsed time to zero. */
  public void restart() {
    now = nanos.getAsLong();
    begun = now;
  }

  /** Returns the clock's time at the last frame in nanoseconds; the clock goes on in pauses. */
  public long nanos() {
    return now;
  }

  /** Returns the sum of all pauses in nanoseconds. */
  public long paused() {
    return stood;
  }

  /**
   * Returns the elapsed seconds at the last frame, pauses not counted; 0 before the first frame.
   */
  public double seconds() {
    return (now - begun) * 1e-9;
  }
}
