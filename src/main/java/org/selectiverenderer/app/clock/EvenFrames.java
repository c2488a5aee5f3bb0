package org.selectiverenderer.app.clock;

import java.util.Locale;

/**
 * The times of the frames of a recorded path: equally spaced from its first time to its last, both
 * included where the rate lets it. Not a clock of the wall, so that the same path gives the same
 * frames on every machine, with and without a picture.
 *
 * @param start seconds
 * @param end seconds, not before start
 * @param rate frames per second of the path's time
 */
public record EvenFrames(double start, double end, double rate) implements FrameSchedule {
  /** Frames beyond which a path or a rate must be a slip: 46 hours at 60 per second. */
  public static final long MOST_FRAMES = 10_000_000;

  public EvenFrames {
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

  /** The number of frames; at least one. */
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
