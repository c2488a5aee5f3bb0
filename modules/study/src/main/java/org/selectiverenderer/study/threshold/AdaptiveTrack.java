package org.selectiverenderer.study.threshold;

/**
 * An adaptive track: the trials of one participant with one object, whose next version depends on
 * the answers so far.
 */
sealed interface AdaptiveTrack permits Staircase, AscendingSeries {
  /** Returns the rung of the version that the next trial shows. */
  int rung();

  /** Records the answer to a trial at {@link #rung}. */
  void answered(boolean correct);

  /** Returns whether the track has ended. */
  boolean over();

  /**
   * Returns the estimate; {@link ThresholdEstimate.Kind#OPEN} as long as the track has not ended.
   */
  ThresholdEstimate estimate();
}
