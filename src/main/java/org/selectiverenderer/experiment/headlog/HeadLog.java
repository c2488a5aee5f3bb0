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
