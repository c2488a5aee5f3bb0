package org.selectiverenderer.study.headlog;

import java.util.List;

/**
 * The contents of a head log.
 *
 * @param samples in order of time, at least one
 */
public record HeadLog(HeadLogMetadata description, List<HeadSample> samples) {
  public HeadLog {
    samples = List.copyOf(samples);
    if (samples.isEmpty()) {
      throw new IllegalArgumentException("a head log has samples");
    }
  }

  /** Returns the time from the first sample to the last, in seconds. */
  public double duration() {
    return samples.get(samples.size() - 1).t() - samples.get(0).t();
  }

  /** Shortest pause in seconds; a smaller difference of the clocks comes from rounding. */
  private static final double SHORTEST_PAUSE = 0.005;

  /**
   * Returns for how long the session was paused between a sample and the one before, in seconds:
   * the time by the monotonic clock beyond the frame's duration. 0 for none, and in a log without
   * that clock.
   */
  double pauseBefore(int sample) {
    if (sample == 0) {
      return 0;
    }
    HeadSample before = samples.get(sample - 1);
    HeadSample now = samples.get(sample);
    double pause = now.moment().mono() - before.moment().mono() - now.frameMs() / 1000;
    return pause > SHORTEST_PAUSE ? pause : 0;
  }

  /**
   * Returns how long the frame of a sample was shown, in seconds: until the next one; the last
   * frame counts as long as the one before.
   */
  double shown(int sample) {
    if (samples.size() < 2) {
      return 0;
    }
    int at = Math.min(sample, samples.size() - 2);
    return samples.get(at + 1).t() - samples.get(at).t();
  }
}
