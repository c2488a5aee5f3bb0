package org.selectiverenderer.experiment.headlog;

import java.util.List;

/**
 * A head log that was read.
 *
 * @param samples in order of time, at least one
 */
public record HeadLog(HeadLogDescription description, List<HeadSample> samples) {
  public HeadLog {
    samples = List.copyOf(samples);
    if (samples.isEmpty()) {
      throw new IllegalArgumentException("a head log has samples");
    }
  }

  /** From the first sample to the last, in seconds. */
  public double duration() {
    return samples.get(samples.size() - 1).t() - samples.get(0).t();
  }

  /** Less than this is what rounding leaves, in seconds. */
  private static final double SHORTEST_PAUSE = 0.005;

  /**
   * For how long the session was paused between a sample and the one before, in seconds: what the
   * machine's clock went on beyond the frame's own time. 0 for none, and in a log without that
   * clock.
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
   * How long a sample was shown, in seconds: until the next one; the last as long as the one
   * before.
   */
  double shown(int sample) {
    if (samples.size() < 2) {
      return 0;
    }
    int at = Math.min(sample, samples.size() - 2);
    return samples.get(at + 1).t() - samples.get(at).t();
  }
}
