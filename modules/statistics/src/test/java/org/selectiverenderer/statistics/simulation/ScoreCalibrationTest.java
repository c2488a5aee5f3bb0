package org.selectiverenderer.statistics.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionScore;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import org.selectiverenderer.statistics.detection.Response;

/**
 * Observers that are calibrated to printed means give these means when their answers are scored.
 */
class ScoreCalibrationTest {
  private static final int PARTICIPANTS = 4000;

  /** Consistent objects of the kitchen, all conditions: Table 6. */
  private static final List<ScoreTarget> KITCHEN =
      List.of(
          new ScoreTarget(1.14, 0.54, -0.01, 0.62),
          new ScoreTarget(0.97, 0.40, 0.20, 0.56),
          new ScoreTarget(0.89, 0.48, 0.40, 0.43));

  /** Inconsistent objects beside the sofa, with four present: the coarsest scores. */
  private static final List<ScoreTarget> FEW =
      List.of(
          new ScoreTarget(0.84, 0.95, 0.10, 0.45),
          new ScoreTarget(0.72, 0.93, 0.16, 0.42),
          new ScoreTarget(0.60, 0.86, 0.24, 0.29));

  @ParameterizedTest
  @EnumSource
  void theScoresHaveTheMeansThatWereWanted(ConfidenceThreshold level) {
    means(KITCHEN, 12, level);
    means(FEW, 4, level);
  }

  private static void means(List<ScoreTarget> wanted, int objects, ConfidenceThreshold level) {
    ScoreCalibration.Calibrated calibrated = ScoreCalibration.of(wanted, objects);
    assertThat(calibrated.exact()).isTrue();
    ScoreTarget target = wanted.get(level.ordinal());
    SummaryStatistics d = new SummaryStatistics();
    SummaryStatistics b = new SummaryStatistics();
    scores(calibrated.observer(), objects, level)
        .forEach(
            score -> {
              d.addValue(score.detection().dPrime());
              b.addValue(score.detection().logBeta());
            });
    double errors = 3.5 / Math.sqrt(PARTICIPANTS);
    assertThat(d.getMean()).isCloseTo(target.dPrime(), within(errors * d.getStandardDeviation()));
    assertThat(b.getMean()).isCloseTo(target.logBeta(), within(errors * b.getStandardDeviation()));
  }

  @Test
  void theFirstLevelHasTheStandardDeviationsThatWereWanted() {
    SummaryStatistics d = new SummaryStatistics();
    scores(ScoreCalibration.of(KITCHEN, 12).observer(), 12, ConfidenceThreshold.ALL)
        .forEach(score -> d.addValue(score.detection().dPrime()));

    assertThat(d.getStandardDeviation()).isCloseTo(0.54, within(0.03));
  }

  @Test
  void aDeviationBelowTheScatterOfCountsLeavesNoSpread() {
    List<ScoreTarget> narrow =
        KITCHEN.stream()
            .map(level -> new ScoreTarget(level.dPrime(), 0.01, level.logBeta(), 0.01))
            .toList();

    RecognitionObserver observer = ScoreCalibration.of(narrow, 12).observer();

    assertThat(observer.sensitivitySpread()).isZero();
    assertThat(observer.criterionSpread()).isZero();
  }

  @Test
  void ratesThatWouldRiseWithTheConfidenceAreHeldAndTold() {
    List<ScoreTarget> rising =
        List.of(
            new ScoreTarget(1, 0.5, 0.5, 0.4),
            new ScoreTarget(1, 0.5, 0, 0.4),
            new ScoreTarget(1, 0.5, 0, 0.4));

    ScoreCalibration.Calibrated calibrated = ScoreCalibration.of(rising, 12);

    assertThat(calibrated.exact()).isFalse();
    assertThat(calibrated.observer().hits().get(1)).isEqualTo(calibrated.observer().hits().get(0));
  }

  private static List<DetectionScore> scores(
      RecognitionObserver observer, int objects, ConfidenceThreshold level) {
    List<Boolean> present = IntStream.range(0, 2 * objects).mapToObj(i -> i % 2 == 0).toList();
    List<Response> responses = new ArrayList<>();
    SplittableRandom random = new SplittableRandom(5);
    for (int participant = 0; participant < PARTICIPANTS; participant++) {
      List<RecognitionObserver.RecognitionAnswer> answers = observer.answers(present, random);
      for (int object = 0; object < present.size(); object++) {
        responses.add(
            new Response(
                Integer.toString(participant),
                "high",
                "kitchen",
                Integer.toString(object),
                "consistent",
                present.get(object),
                answers.get(object).yes(),
                answers.get(object).confidence(),
                SourceLocation.of("drawn")));
      }
    }
    return new DetectionScorer(ExtremeRateCorrection.LOG_LINEAR, LowConfidencePolicy.AS_NO)
        .scores(responses, List.of(level));
  }
}
