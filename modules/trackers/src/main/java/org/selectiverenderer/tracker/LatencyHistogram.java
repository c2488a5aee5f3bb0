package org.selectiverenderer.tracker;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;

/**
 * A histogram of latencies, of fixed size for any duration; any thread adds values without locks
 * and allocations. Buckets are a microsecond wide up to {@value #STEPS} microseconds; from there
 * each doubling has as many buckets, so that no percentile is off by more than half a percent (the
 * layout of Tene's HdrHistogram).
 */
public final class LatencyHistogram {
  private static final int BITS = 7;

  /** Number of buckets in the first part, and in each doubling after it. */
  private static final int STEPS = 1 << BITS;

  private static final int NANOS = 1000;

  private final AtomicLongArray counts = new AtomicLongArray(step(Long.MAX_VALUE / NANOS) + 1);
  private final AtomicLong count = new AtomicLong();
  private final AtomicLong longest = new AtomicLong();

  /** Returns the bucket of a duration in microseconds. */
  private static int step(long micros) {
    int doublings = Math.max(0, Long.SIZE - 1 - Long.numberOfLeadingZeros(micros | 1) - BITS);
    return doublings * STEPS + (int) (micros >>> doublings);
  }

  /** Returns the midpoint of a bucket in nanoseconds. */
  private static double middle(int step) {
    int doublings = Math.max(0, step / STEPS - 1);
    return (step - doublings * STEPS + 0.5) * (1L << doublings) * NANOS;
  }

  /** Adds a duration in nanoseconds; a negative one counts as 0. */
  public void record(long nanos) {
    long positive = Math.max(0, nanos);
    counts.incrementAndGet(step(positive / NANOS));
    count.incrementAndGet();
    // No accumulator function: a lambda may allocate.
    long seen = longest.get();
    while (positive > seen && !longest.compareAndSet(seen, positive)) {
      seen = longest.get();
    }
  }

  /** Returns the number of durations. */
  public long count() {
    return count.get();
  }

  /** Returns the longest duration in milliseconds; 0 without any. */
  public double maxMs() {
    return longest.get() * 1e-6;
  }

  /**
   * Returns a percentile of the durations in milliseconds: the midpoint of its bucket, but never
   * more than the longest duration; 0 without any.
   *
   * @param share 0.5 for the median, 0.99 for the 99th percentile, 1 for the longest
   */
  public double percentileMs(double share) {
    long all = count();
    long wanted = Math.max(1, (long) Math.ceil(share * all));
    if (all == 0 || wanted >= all) {
      return maxMs();
    }
    long seen = 0;
    for (int i = 0; i < counts.length(); i++) {
      seen += counts.get(i);
      if (seen >= wanted) {
        return Math.min(middle(i), longest.get()) * 1e-6;
      }
    }
    return maxMs();
  }
}
