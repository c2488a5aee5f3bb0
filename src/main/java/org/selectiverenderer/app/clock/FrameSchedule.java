package org.selectiverenderer.app.clock;

import java.util.OptionalDouble;
import org.selectiverenderer.app.settings.FollowedPath;

/** A sequence of frames whose times are known before the run; it has at least one frame. */
interface FrameSchedule {
  /** Returns whether the schedule has a frame of this index, counted from 0. */
  boolean has(long frame);

  /** Returns the time of a frame in seconds. */
  double time(long frame);

  /**
   * Creates the schedule of a followed path: at the given frame rate, or one frame for each row of
   * the path.
   *
   * @param duration seconds after which the schedule ends; empty for the path's own end
   */
  static FrameSchedule of(FollowedPath followed, OptionalDouble duration) {
    double start = followed.path().start();
    double end = duration.isPresent() ? start + duration.getAsDouble() : followed.path().end();
    return followed.rate().isPresent()
        ? new EvenFrames(start, end, followed.rate().getAsDouble())
        : new RowFrames(followed.path(), end);
  }
}
