package org.selectiverenderer.app.head;

import java.time.Instant;
import org.selectiverenderer.app.clock.Stopwatch;

/**
 * The time at which a frame was stepped, on each clock of the run.
 *
 * @param time the scene's time of the frame, in seconds
 * @param nanos the monotonic clock in nanoseconds, which goes on in pauses
 * @param paused the sum of all pauses of the run so far, in nanoseconds
 * @param wall the date and time
 */
public record FrameTimestamp(double time, long nanos, long paused, Instant wall) {
  /** Returns the times of a frame that is stepped now, at the stopwatch's last tick. */
  public static FrameTimestamp now(double time, Stopwatch watch) {
    return new FrameTimestamp(time, watch.nanos(), watch.paused(), Instant.now());
  }

  /** Returns the milliseconds from another frame to this one, pauses not counted. */
  double millisecondsSince(FrameTimestamp before) {
    return ((nanos - paused) - (before.nanos - before.paused)) * 1e-6;
  }
}
