package org.selectiverenderer.tracker;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;

/**
 * How long things took: a histogram of fixed size that any thread adds to without locks and
 * allocations. Steps of 10 microseconds up to 100 ms; what takes longer counts as that long, except
 * for {@link #maxMs}.
 */
public final class LatencyMeter {
  private static final long STEP = 10_000;
  private static final int STEPS = 10_000;

  private final AtomicLongArray counts = new AtomicLongArray(STEPS + 1);
  private final AtomicLong count = new AtomicLong();
  private final AtomicLong longest = new AtomicLong();

  /** Adds a duration in nanoseconds; a negative one counts as 0. */
  public void record(long nanos) {
    long positive = Math.max(0, nanos);
    counts.incrementAndGet((int) Math.min(STEPS, positive / STEP));
    count.incrementAndGet();
    // No accumulator function: a lambda may allocate.
    long seen = longest.get();
    while (positive > seen && !longest.compareAndSet(seen, positive)) {
      seen = longest.get();
    }
  }

  /** How many were added. */
  public long count() {
    return count.get();
  }

  /** The longest, in milliseconds; 0 without any. */
  public double maxMs() {
    return longest.get() * 1e-6;
  }

  /**
   * The duration that a share of all did not exceed, in milliseconds, to the middle of a step; 0
   * without any.
   *
   * @param share 0.5 for the median, 0.99 for the 99th percentile
   */
  public double percentileMs(double share) {
    long wanted = Math.max(1, (long) Math.ceil(share * count()));
    long seen = 0;
    for (int i = 0; i <= STEPS && count() > 0; i++) {
      seen += counts.get(i);
      if (seen >= wanted) {
        return (i + 0.5) * STEP * 1e-6;
      }
    }
    return 0;
  }
}
