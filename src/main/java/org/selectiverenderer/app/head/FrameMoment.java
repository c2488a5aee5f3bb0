package org.selectiverenderer.app.head;

import java.time.Instant;
import org.selectiverenderer.app.clock.Stopwatch;

/**
 * When a frame was stepped, by the clocks of the machine.
 *
 * @param time of the frame in seconds, as the scene has it
 * @param nanos of the run's clock, which goes on in pauses
 * @param paused nanoseconds that the run was paused until then
 * @param wall date and time
 */
public record FrameMoment(double time, long nanos, long paused, Instant wall) {
  /** A frame that is stepped now, at the watch's last tick. */
  public static FrameMoment now(double time, Stopwatch watch) {
    return new FrameMoment(time, watch.nanos(), watch.paused(), Instant.now());
  }

  /** From another frame to this one in milliseconds, pauses not counted. */
  double millisecondsSince(FrameMoment before) {
    return ((nanos - paused) - (before.nanos - before.paused)) * 1e-6;
  }
}
