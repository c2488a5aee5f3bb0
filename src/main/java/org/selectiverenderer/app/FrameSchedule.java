package org.selectiverenderer.app;

import org.selectiverenderer.runtime.navigation.CameraPath;

/** Which frames there are, and their times in seconds. */
interface FrameSchedule {
  /** Whether there is a frame of that number, counted from 0. */
  boolean has(long frame);

  /** Its time. */
  double time(long frame);

  /** The first frame is drawn: a clock of the wall begins here. */
  void begin();

  /** The frames of a recorded path. */
  static FrameSchedule of(PathClock clock) {
    return new FrameSchedule() {
      @Override
      public boolean has(long frame) {
        return frame < clock.frames();
      }

      @Override
      public double time(long frame) {
        return clock.time(frame);
      }

      @Override
      public void begin() {
        // A path's time is its own.
      }
    };
  }

  /** The rows of a path, up to an end. */
  static FrameSchedule rows(CameraPath path, double end) {
    return new FrameSchedule() {
      @Override
      public boolean has(long frame) {
        return frame < path.rows() && (frame == 0 || path.time((int) frame) <= end);
      }

      @Override
      public double time(long frame) {
        return path.time((int) frame);
      }

      @Override
      public void begin() {
        // A path's time is its own.
      }
    };
  }

  /** The frames of a run's path. */
  static FrameSchedule path(RunSettings settings, CameraPath path) {
    double end =
        settings.duration().isPresent()
            ? path.start() + settings.duration().getAsDouble()
            : path.end();
    return settings.pathFrames()
        ? rows(path, end)
        : of(new PathClock(path.start(), end, RunSettings.PATH_RATE));
  }

  /**
   * As many frames as fit into a duration, and at least one.
   *
   * @param seconds by the clock on the wall, from the end of the first frame
   */
  static FrameSchedule wall(double seconds) {
    return new FrameSchedule() {
      private long begun;

      @Override
      public boolean has(long frame) {
        return frame == 0 || elapsed() < seconds;
      }

      @Override
      public double time(long frame) {
        return frame == 0 ? 0 : elapsed();
      }

      @Override
      public void begin() {
        begun = System.nanoTime();
      }

      private double elapsed() {
        return (System.nanoTime() - begun) * 1e-9;
      }
    };
  }
}
