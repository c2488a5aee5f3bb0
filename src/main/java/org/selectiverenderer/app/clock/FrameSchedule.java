package org.selectiverenderer.app.clock;

import java.util.OptionalDouble;
import org.selectiverenderer.app.settings.PathPlaybackSettings;
import org.selectiverenderer.browser.viewer.CameraPath;

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
  static FrameSchedule of(PathPlaybackSettings followed, OptionalDouble duration) {
    double start = followed.path().start();
    double end = duration.isPresent() ? start + duration.getAsDouble() : followed.path().end();
    return followed.rate().isPresent()
        ? new FixedRateSchedule(start, end, followed.rate().getAsDouble())
        : new PathRowSchedule(followed.path(), end);
  }

  /**
   * A schedule with one frame for each row of a path.
   *
   * @param end seconds after which rows are left out; the first row always counts
   */
  record PathRowSchedule(CameraPath path, double end) implements FrameSchedule {
    @Override
    public boolean has(long frame) {
      return frame < path.rows() && (frame == 0 || time(frame) <= end);
    }

    @Override
    public double time(long frame) {
      return path.time((int) frame);
    }
  }
}
