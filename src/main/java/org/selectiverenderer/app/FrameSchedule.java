package org.selectiverenderer.app;

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
