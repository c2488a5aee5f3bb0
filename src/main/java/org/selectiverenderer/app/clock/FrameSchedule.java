package org.selectiverenderer.app.clock;

import java.util.OptionalDouble;
import org.selectiverenderer.app.settings.FollowedPath;

/** Frames whose times are known beforehand; there is at least one. */
interface FrameSchedule {
  /** Whether there is a frame of that number, counted from 0. */
  boolean has(long frame);

  /** Its time in seconds. */
  double time(long frame);

  /**
   * The frames of a path.
   *
   * @param duration seconds after which it ends; empty for the path's own end
   */
  static FrameSchedule of(FollowedPath followed, OptionalDouble duration) {
    double start = followed.path().start();
    double end = duration.isPresent() ? start + duration.getAsDouble() : followed.path().end();
    return followed.rate().isPresent()
        ? new EvenFrames(start, end, followed.rate().getAsDouble())
        : new RowFrames(followed.path(), end);
  }
}
