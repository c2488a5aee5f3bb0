package org.selectiverenderer.study.headlog;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;

/**
 * The contents of a head log.
 *
 * @param samples in order of time, at least one
 * @param from begin of the time in view, in seconds of the samples' {@code t}
 * @param to end of the time in view
 */
public record HeadLog(
    HeadLogMetadata description, List<HeadSample> samples, double from, double to) {
  public HeadLog {
    samples = List.copyOf(samples);
    if (samples.isEmpty()) {
      throw new IllegalArgumentException("a head log has samples");
    }
  }

  /** Creates a log that is in view from its first sample to its last. */
  public HeadLog(HeadLogMetadata description, List<HeadSample> samples) {
    this(description, samples, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
  }

  /**
   * Returns this log with limits of the time in view, as an exposure has: from when the picture is
   * complete until it begins to fade out. {@link HeadLogAnalysis} counts the time in view only, of
   * which pauses and frames without a visible picture are not a part.
   */
  public HeadLog inView(double begin, double end) {
    return new HeadLog(description, samples, begin, end);
  }

  /**
   * Returns this log with only some of its frames in view, as those in which the viewer was in an
   * area; the others count like frames without a picture.
   *
   * @param counts takes the index of a sample
   */
  public HeadLog where(IntPredicate counts) {
    List<HeadSample> some = new ArrayList<>(samples.size());
    for (int i = 0; i < samples.size(); i++) {
      some.add(counts.test(i) ? samples.get(i) : samples.get(i).unseen());
    }
    return new HeadLog(description, some, from, to);
  }

  /** Returns whether a sample's frame was in view, if only for a part of its time. */
  public boolean inView(int sample) {
    return samples.get(sample).visible()
        && end(sample) >= from
        && samples.get(sample).t() <= to
        && (shown(sample) > 0 || frame(sample) <= 0);
  }

  /** Returns when a sample's frame came into view. */
  public double start(int sample) {
    return Math.max(from, samples.get(sample).t());
  }

  private double end(int sample) {
    return samples.get(sample).t() + frame(sample);
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
   * Returns how long the frame of a sample was shown in the time between {@link #from} and {@link
   * #to}, in seconds: until the next one; the last frame counts as long as the one before.
   */
  public double shown(int sample) {
    return Math.max(0, Math.min(to, end(sample)) - start(sample));
  }

  private double frame(int sample) {
    if (samples.size() < 2) {
      return 0;
    }
    int at = Math.min(sample, samples.size() - 2);
    return samples.get(at + 1).t() - samples.get(at).t();
  }
}
