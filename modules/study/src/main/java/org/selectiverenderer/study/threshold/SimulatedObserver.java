package org.selectiverenderer.study.threshold;

import java.util.Map;
import java.util.Random;

/**
 * A simulated observer: detects, or recognises, with a probability that is a logistic function of
 * the logarithm of the number of polygons, else guesses, and has a small lapse rate.
 *
 * <p>Discrimination becomes harder with more polygons, recognition easier; at the threshold either
 * succeeds half of the time.
 */
public final class SimulatedObserver {
  private static final double SLOPE = 4;
  private static final double SLIPS = 0.02;

  private final ThresholdTask task;
  private final Map<String, StimulusLevels> ladders;
  private final double share;
  private final Random random;

  /**
   * Makes an observer.
   *
   * @param share the threshold of each object, as a share of its polygons
   */
  public SimulatedObserver(
      ThresholdTask task, Map<String, StimulusLevels> ladders, double share, long seed) {
    this.task = task;
    this.ladders = Map.copyOf(ladders);
    this.share = share;
    random = new Random(seed * 0x9E3779B97F4A7C15L);
  }

  /** Returns the answer of this observer. */
  public String answer(ThresholdTrial trial) {
    StimulusLevels ladder = ladders.get(trial.object());
    if (ladder == null) {
      throw new IllegalArgumentException("no versions of " + trial.object());
    }
    double above = Math.log(ladder.at(trial.rung()) / (share * ladder.all()));
    double more = 1 / (1 + Math.exp(-SLOPE * above));
    double succeeds = task == ThresholdTask.TELL_APART ? 1 - more : more;
    boolean knows = trial.catches() || random.nextDouble() < succeeds;
    if (knows && random.nextDouble() >= SLIPS) {
      return trial.right();
    }
    if (task == ThresholdTask.RECOGNISE) {
      return ThresholdTrial.NONE;
    }
    return trial.choices().get(random.nextInt(trial.choices().size()));
  }
}
