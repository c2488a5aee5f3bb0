package org.selectiverenderer.experiment.threshold;

/** The trials of one participant with one object: which version comes next, and when it is over. */
sealed interface PilotTrack permits Staircase, AscendingSeries {
  /** The rung that the next trial shows. */
  int rung();

  /** The participant has answered a trial at {@link #rung}. */
  void answered(boolean correct);

  /** Whether there is nothing more to ask. */
  boolean over();

  /** What has been found; {@link ThresholdEstimate.Kind#OPEN} as long as it is not over. */
  ThresholdEstimate estimate();
}
