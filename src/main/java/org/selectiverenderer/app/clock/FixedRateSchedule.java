package org.selectiverenderer.app.clock;

import java.util.Locale;

/**
 * A schedule of frames at a fixed rate over a recorded path, from the path's first time to its
 * last. It does not depend on the real time, so that the same path gives the same frames on every
 * machine, with and without rendering.
 *
 * @param start seconds
 * @param end seconds, not before start
 * @param rate frames per second of the path's time
 */
public record FixedRateSchedule(double start, double end, double rate) implements FrameSchedule {
  /**
   * The largest number of frames; more must be a typing error in a path or a rate (46 hours at 60
   * frames per second).
   */
  public static final long MOST_FRAMES = 10_000_000;

  public FixedRateSchedule {
    if (!(rate > 0) || !(end >= start)) {
      throw new IllegalArgumentException("the rate of a path must be above 0");
    }
    if ((end - start) * rate > MOST_FRAMES) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "a path of %.0f s at %.0f frames/s has more than %d frames",
              end - start,
              rate,
              MOST_FRAMES));
    }
  }

  /** Returns the number of frames, at least one. */
  public long frames() {
    // The small share makes up for a duration that is a rounding error short of whole frames.
    return (long) Math.floor((end - start) * rate + 1e-6) + 1;
  }

  @Override
  public boolean has(long frame) {
    return frame < frames();
  }

  @Override
  public double time(long frame) {
    return start + frame / rate;
  }
}
