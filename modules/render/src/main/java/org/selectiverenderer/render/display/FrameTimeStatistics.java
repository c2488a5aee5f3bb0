package org.selectiverenderer.render.display;

import java.util.Arrays;

/**
 * Statistics of frame times in milliseconds. Mean and maximum are those of all frames; the
 * percentiles are those of the latest frames, as many as the store holds. Not thread-safe.
 */
public final class FrameTimeStatistics {
  private final double[] store;
  private long count;
  private double sum;
  private double max;

  /**
   * @param capacity the number of latest frames kept, at least 1
   */
  public FrameTimeStatistics(int capacity) {
    store = new double[capacity];
  }

  public void add(double ms) {
    store[(int) (count++ % store.length)] = ms;
    sum += ms;
    max = Math.max(max, ms);
  }

  /**
   * A summary of frame times in milliseconds; zeros when there was no frame. A percentile is the
   * smallest time kept that is not exceeded by that share of the times (nearest-rank method).
   *
   * @param kept the times that the percentiles are computed from
   */
  public record Summary(
      long count, double mean, double p50, double p95, double p99, double max, Sorted kept) {
    /** Returns the mean frames per second; 0 when there was no frame. */
    public double framesPerSecond() {
      return mean > 0 ? 1000 / mean : 0;
    }

    /**
     * Returns the share of the frames kept, 0 to 1, that took longer than a time in milliseconds.
     */
    public double shareAbove(double ms) {
      return kept.shareAbove(ms);
    }
  }

  /** Times in ascending order; equal to others that are the same. */
  public static final class Sorted {
    private final double[] times;

    /**
     * @param times in any order; taken over
     */
    private Sorted(double[] times) {
      this.times = times;
      Arrays.sort(this.times);
    }

    static Sorted of(double... times) {
      return new Sorted(times.clone());
    }

    private double percentile(double share) {
      return times.length == 0 ? 0 : times[(int) Math.ceil(share * times.length) - 1];
    }

    private double shareAbove(double ms) {
      return times.length == 0
          ? 0
          : (double) Arrays.stream(times).filter(time -> time > ms).count() / times.length;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Sorted sorted && Arrays.equals(times, sorted.times);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(times);
    }
  }

  public Summary summary() {
    Sorted kept = new Sorted(Arrays.copyOf(store, (int) Math.min(count, store.length)));
    return new Summary(
        count,
        count == 0 ? 0 : sum / count,
        kept.percentile(0.5),
        kept.percentile(0.95),
        kept.percentile(0.99),
        max,
        kept);
  }
}
