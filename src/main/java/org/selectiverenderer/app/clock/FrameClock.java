package org.selectiverenderer.app.clock;

import java.util.List;

/** Which frames a run steps and when it has no more. Belongs to the thread that steps. */
public interface FrameClock {
  /**
   * The frames that are due before the next picture, taken from those left.
   *
   * @param elapsed seconds since the run's first frame, pauses not counted
   * @return their times in seconds, forward; may be none
   */
  List<Double> due(double elapsed);

  /**
   * Whether no frame is left.
   *
   * @param elapsed as told to {@link #due} before
   */
  boolean over(double elapsed);
}
