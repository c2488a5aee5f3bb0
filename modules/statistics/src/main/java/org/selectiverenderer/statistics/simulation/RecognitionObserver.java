package org.selectiverenderer.statistics.simulation;

import java.util.List;
import java.util.SplittableRandom;
import org.apache.commons.math3.distribution.NormalDistribution;

/**
 * A population of observers who answer a recognition list, with a confidence from 1 to 5. Each
 * level of confidence (all answers, 3 to 5, 5 only) has a sensitivity and a criterion of its own;
 * answers below a level count as "no". {@link ScoreCalibration} finds the observers whose scores
 * have given means.
 *
 * @param hits z of the rate of "yes" about present objects at each level, falling
 * @param falseAlarms z of the rate of "yes" about absent objects at each level, falling
 * @param sensitivitySpread standard deviation of d' between participants, alike at all levels
 * @param criterionSpread standard deviation of c between participants, alike at all levels
 */
public record RecognitionObserver(
    List<Double> hits, List<Double> falseAlarms, double sensitivitySpread, double criterionSpread) {
  /** The number of levels of confidence. */
  static final int LEVELS = 3;

  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

  /** Distances from the criterion at which a "no" has a confidence of 2, 3, 4 and 5. */
  private static final double[] CERTAIN_NO = {0.15, 0.35, 0.6, 0.9};

  /** Checks that there is a rate for each level. */
  public RecognitionObserver {
    hits = List.copyOf(hits);
    falseAlarms = List.copyOf(falseAlarms);
    if (hits.size() != LEVELS || falseAlarms.size() != LEVELS) {
      throw new IllegalArgumentException("an observer has rates for three levels of confidence");
    }
  }

  /**
   * An answer to "was it there?".
   *
   * @param confidence from 1 to 5
   */
  public record RecognitionAnswer(boolean yes, int confidence) {}

  /** Draws a participant's answers, one for each object. */
  public List<RecognitionAnswer> answers(List<Boolean> present, SplittableRandom random) {
    double sensitivity = sensitivitySpread * normal(random);
    double criterion = criterionSpread * normal(random);
    return present.stream()
        .map(
            there ->
                answer(
                    there ? hits : falseAlarms,
                    (there ? sensitivity : -sensitivity) / 2 - criterion,
                    random))
        .toList();
  }

  /**
   * Draws an answer: the less likely the drawn evidence, the higher the level at which it still is
   * a "yes".
   */
  private static RecognitionAnswer answer(
      List<Double> levels, double shift, SplittableRandom random) {
    double evidence = normal(random) - shift;
    boolean even = random.nextBoolean();
    if (evidence < levels.get(2)) {
      return new RecognitionAnswer(true, 5);
    } else if (evidence < levels.get(1)) {
      return new RecognitionAnswer(true, even ? 4 : 3);
    } else if (evidence < levels.get(0)) {
      return new RecognitionAnswer(true, even ? 2 : 1);
    }
    int confidence = 1;
    for (double from : CERTAIN_NO) {
      confidence += evidence - levels.get(0) >= from ? 1 : 0;
    }
    return new RecognitionAnswer(false, confidence);
  }

  /** Returns a normal variate by inversion, which is the same on every Java version. */
  private static double normal(SplittableRandom random) {
    double uniform = (random.nextLong() >>> 11) * 0x1.0p-53 + 0x1.0p-54;
    return NORMAL.inverseCumulativeProbability(uniform);
  }
}
