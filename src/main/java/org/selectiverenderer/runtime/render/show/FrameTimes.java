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
   */
  public record Summary(long count, double mean, double p50, double p95, double p99, double max) {
    /** Frames per second; 0 when there was no frame. */
    public double framesPerSecond() {
      return mean > 0 ? 1000 / mean : 0;
    }
  }

  public Summary summary() {
    double[] sorted = Arrays.copyOf(store, (int) Math.min(count, store.length));
    Arrays.sort(sorted);
    return new Summary(
        count,
        count == 0 ? 0 : sum / count,
        percentile(sorted, 0.5),
        percentile(sorted, 0.95),
        percentile(sorted, 0.99),
        max);
  }

  private static double percentile(double[] sorted, double share) {
    return sorted.length == 0 ? 0 : sorted[(int) Math.ceil(share * sorted.length) - 1];
  }
}
