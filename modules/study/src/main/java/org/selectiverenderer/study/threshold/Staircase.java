package org.selectiverenderer.study.threshold;

import java.util.List;
import org.selectiverenderer.study.design.UpDownStaircase;

/**
 * A transformed up-down staircase on a ladder of versions. It begins with the fewest polygons,
 * which are easy to tell from the original. The threshold is the geometric mean of the polygons at
 * the last reversals.
 */
final class Staircase implements AdaptiveTrack {
  private final StimulusLevels ladder;
  private final UpDownStaircase track;

  Staircase(StaircaseRule rule, StimulusLevels ladder) {
    this.ladder = ladder;
    track =
        new UpDownStaircase(
            ladder.original(), rule.down(), rule.reversals(), rule.discarded(), rule.mostTrials());
  }

  @Override
  public int rung() {
    return track.level();
  }

  @Override
  public void answered(boolean correct) {
    track.answered(correct);
  }

  @Override
  public boolean over() {
    return track.over();
  }

  @Override
  public ThresholdEstimate estimate() {
    if (track.converged()) {
      double mean =
          track.counting().stream()
              .mapToDouble(turn -> Math.log(ladder.at(turn)))
              .average()
              .orElseThrow();
      return new ThresholdEstimate(ThresholdEstimate.Kind.FOUND, Math.exp(mean));
    }
    if (track.pinned()) {
      return new ThresholdEstimate(
          rung() == 0 ? ThresholdEstimate.Kind.BELOW : ThresholdEstimate.Kind.ABOVE,
          ladder.at(rung()));
    }
    return new ThresholdEstimate(ThresholdEstimate.Kind.OPEN, ladder.at(rung()));
  }

  /** Returns the rungs of the reversals so far. */
  List<Integer> turns() {
    return track.reversals();
  }
}
