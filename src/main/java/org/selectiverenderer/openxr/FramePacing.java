package org.selectiverenderer.openxr;

/** Counts the frames of a headset, and those that came too late to be shown. */
final class FramePacing {
  private long last;
  private boolean going;
  private long frames;
  private long missed;
  private double rate;

  /** There were no frames for a while, and none was to be. */
  void restart() {
    going = false;
  }

  /** A frame is due. */
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

  /** Periods of the display in which the frame before was shown again. */
  long missed() {
    return missed;
  }

  /** Frames per second that the runtime wants; 0 before the first. */
  double rate() {
    return rate;
  }
}
