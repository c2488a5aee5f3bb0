package org.selectiverenderer.study.threshold;

import java.util.ArrayList;
import java.util.List;

/**
 * A transformed up-down staircase on a ladder of versions. It begins with the fewest polygons,
 * which are easy to tell from the original, with large steps, which are halved at each reversal
 * until they are one rung. The threshold is the geometric mean of the polygons at the last
 * reversals.
 */
final class Staircase implements AdaptiveTrack {
  /**
   * Number of consecutive steps beyond an end of the ladder that end the staircase: an observer who
   * only guesses passes the ten trials of a two-down rule once in a thousand times.
   */
  private static final int BEYOND = 5;

  private final StaircaseRule rule;
  private final StimulusLevels ladder;
  private final int hardest;
  private final List<Integer> turns = new ArrayList<>();
  private int rung;
  private int step;
  private int inARow;
  private int direction;
  private int beyond;
  private int trials;

  Staircase(StaircaseRule rule, StimulusLevels ladder) {
    this.rule = rule;
    this.ladder = ladder;
    hardest = ladder.original() - 1;
    step = Math.max(1, ladder.original() / 4);
  }

  @Override
  public int rung() {
    return rung;
  }

  @Override
  public void answered(boolean correct) {
    trials++;
    inARow = correct ? inARow + 1 : 0;
    if (!correct) {
      go(-1);
    } else if (inARow == rule.down()) {
      inARow = 0;
      go(1);
    }
  }

  /**
   * Moves one step on the ladder.
   *
   * @param towards 1 for more polygons, -1 for fewer
   */
  private void go(int towards) {
    if (direction == -towards) {
      turns.add(rung);
      step = Math.max(1, step / 2);
    }
    direction = towards;
    int next = Math.max(0, Math.min(hardest, rung + towards * step));
    beyond = next == rung ? beyond + 1 : 0;
    rung = next;
  }

  @Override
  public boolean over() {
    return turns.size() >= rule.reversals() || beyond >= BEYOND || trials >= rule.mostTrials();
  }

  @Override
  public ThresholdEstimate estimate() {
    if (turns.size() >= rule.reversals()) {
      double mean =
          turns.subList(rule.discarded(), rule.reversals()).stream()
              .mapToDouble(turn -> Math.log(ladder.at(turn)))
              .average()
              .orElseThrow();
      return new ThresholdEstimate(ThresholdEstimate.Kind.FOUND, Math.exp(mean));
    }
    if (beyond >= BEYOND) {
      return new ThresholdEstimate(
          rung == 0 ? ThresholdEstimate.Kind.BELOW : ThresholdEstimate.Kind.ABOVE, ladder.at(rung));
    }
    return new ThresholdEstimate(ThresholdEstimate.Kind.OPEN, ladder.at(rung));
  }

  /** Returns the rungs of the reversals so far. */
  List<Integer> turns() {
    return List.copyOf(turns);
  }
}
