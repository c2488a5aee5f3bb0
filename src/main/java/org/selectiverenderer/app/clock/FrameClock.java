package org.selectiverenderer.app.clock;

import java.util.List;

/**
 * Tells a run which frames are due and when the last one is done. It is confined to the thread that
 * steps the world.
 */
public interface FrameClock {
  /**
   * Removes and returns the frames that are due before the next picture.
   *
   * @param elapsed seconds since the run's first frame, pauses not counted
   * @return the times of these frames in seconds, ascending; may be empty
   */
  List<Double> due(double elapsed);

  /**
   * Returns whether no frame is left.
   *
   * @param elapsed the same value as in the last call of {@link #due}
   */
  boolean over(double elapsed);
}
