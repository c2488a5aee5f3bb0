package org.selectiverenderer.openxr;

/** Counts the frames of a headset, and the display periods without a new frame. */
final class FramePacing {
  private long last;
  private boolean going;
  private long frames;
  private long missed;
  private double rate;

  /** Restarts after a time without frames, which do not count as missed. */
  void restart() {
    going = false;
  }

  /** Counts a frame that is due. */
  void frame(XrSession.FrameTime time) {
    frames++;
    if (time.period() > 0) {
      rate = 1e9 / time.period();
      if (going && time.drawn()) {
        missed += Math.max(0, Math.round((time.display() - last) / (double) time.period()) - 1);
      }
    }
    going = time.drawn();
    last = time.display();
  }

  long frames() {
    return frames;
  }

  /** Returns the number of display periods in which the previous frame was shown again. */
  long missed() {
    return missed;
  }

  /** Returns the runtime's frame rate in frames per second; 0 before the first frame. */
  double rate() {
    return rate;
  }
}
