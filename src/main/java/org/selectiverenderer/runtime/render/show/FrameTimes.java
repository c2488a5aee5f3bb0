package org.selectiverenderer.runtime.render.show;

import java.util.Arrays;

/**
 * Times of frames in milliseconds. Counts all of them; of a long run the percentiles are those of
 * the latest that the store holds, the mean and the maximum those of all. Not thread-safe.
 */
public final class FrameTimes {
  private final double[] store;
  private long count;
  private double sum;
  private double max;

  /**
   * @param capacity number of frames kept, at least 1
   */
  public FrameTimes(int capacity) {
    store = new double[capacity];
  }

  public void add(double ms) {
    store[(int) (count++ % store.length)] = ms;
    sum += ms;
    max = Math.max(max, ms);
  }

  /**
   * All in milliseconds; zeros when there was no frame. A percentile is the smallest time kept that
   * is not exceeded by that share of them (nearest rank).
   *
   * @param kept the times of which the percentiles are
   */
  public record Summary(
      long count, double mean, double p50, double p95, double p99, double max, Sorted kept) {
    /** Frames per second; 0 when there was no frame. */
    public double framesPerSecond() {
      return mean > 0 ? 1000 / mean : 0;
    }

    /** Which share of the frames kept took longer than so many milliseconds, 0 to 1. */
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
