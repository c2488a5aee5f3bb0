package org.selectiverenderer.study.threshold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.study.threshold.ThresholdEstimate.Kind;

/** The paths that staircases and series take, and that they find thresholds that are known. */
class AdaptiveTrackTest {
  /** 10, 20, 40 and so on; the last is the original. */
  private static final StimulusLevels DOUBLING =
      new StimulusLevels(List.of(10, 20, 40, 80, 160, 320, 640, 1280));

  private static final StaircaseRule TWO_DOWN = new StaircaseRule(2, 8, 2, 200);

  private static List<Integer> rungs(AdaptiveTrack track, String answers) {
    List<Integer> rungs = new ArrayList<>();
    for (char answer : answers.toCharArray()) {
      rungs.add(track.rung());
      track.answered(answer == '+');
    }
    return rungs;
  }

  @Test
  void twoRightAnswersMakeItHarderAndAWrongOneEasierByStepsThatShrinkToOneRung() {
    Staircase staircase = new Staircase(new StaircaseRule(2, 4, 0, 100), fine(16));

    // Steps of 4 up to the first turn, 2 up to the second, then 1.
    assertThat(rungs(staircase, "++++-++-")).containsExactly(0, 0, 4, 4, 8, 6, 6, 7);
    assertThat(staircase.rung()).isEqualTo(6);
    assertThat(staircase.turns()).containsExactly(8, 6, 7);
    assertThat(staircase.over()).isFalse();
    assertThat(staircase.estimate().kind()).isEqualTo(Kind.OPEN);
    rungs(staircase, "++");
    assertThat(staircase.turns()).containsExactly(8, 6, 7, 6);
    assertThat(staircase.over()).isTrue();
  }

  /** A ladder with so many reduced versions, each 1.2 times the one before. */
  private static StimulusLevels fine(int rungs) {
    return new StimulusLevels(
        IntStream.rangeClosed(0, rungs)
            .map(i -> (int) Math.round(100 * Math.pow(1.2, i)))
            .boxed()
            .toList());
  }

  @Test
  void theThresholdIsTheGeometricMeanOfTheTurnsThatCount() {
    Staircase staircase = new Staircase(new StaircaseRule(1, 4, 2, 100), DOUBLING);

    rungs(staircase, "++++--+-+");
    assertThat(staircase.turns()).containsExactly(4, 2, 3, 2);
    assertThat(staircase.over()).isTrue();
    assertThat(staircase.estimate().kind()).isEqualTo(Kind.FOUND);
    assertThat(staircase.estimate().polygons()).isCloseTo(Math.sqrt(80 * 40), within(1e-9));
  }

  @Test
  void whoToldEvenTheMostPolygonsFromTheOriginalHasAThresholdAbove() {
    Staircase staircase = new Staircase(TWO_DOWN, DOUBLING);
    while (!staircase.over()) {
      staircase.answered(true);
    }
    assertThat(staircase.estimate()).isEqualTo(new ThresholdEstimate(Kind.ABOVE, 640));
  }

  @Test
  void whoDidNotEvenTellTheFewestHasAThresholdBelow() {
    Staircase staircase = new Staircase(TWO_DOWN, DOUBLING);
    while (!staircase.over()) {
      staircase.answered(false);
    }
    assertThat(staircase.estimate()).isEqualTo(new ThresholdEstimate(Kind.BELOW, 10));
  }

  @Test
  void aStaircaseEndsAfterTheMostTrialsWithNothingFound() {
    Staircase staircase = new Staircase(new StaircaseRule(2, 8, 2, 3), DOUBLING);
    rungs(staircase, "++-");
    assertThat(staircase.over()).isTrue();
    assertThat(staircase.estimate().kind()).isEqualTo(Kind.OPEN);
  }

  /** Levitt 1971, Table I: 70.7 % for two down, 79.4 % for three. */
  @ParameterizedTest
  @CsvSource({"1, 0.5", "2, 0.7071", "3, 0.7937", "4, 0.8409"})
  void theTargetIsLevitts(int down, double target) {
    assertThat(new StaircaseRule(down, 6, 2, 10).target()).isCloseTo(target, within(1e-4));
  }

  @Test
  void peaksAndValleysMustWeighAlike() {
    assertThatThrownBy(() -> new StaircaseRule(2, 7, 2, 10))
        .isInstanceOf(IllegalArgumentException.class);
  }

  /**
   * Observers who tell a version from the original with a probability that falls from 1 to 1/2
   * about a known number of polygons. Over many of them the mean is where the rule's target says.
   */
  @ParameterizedTest
  @CsvSource({"2, 300", "2, 900", "3, 300", "3, 900"})
  void aKnownThresholdIsFound(int down, double threshold) {
    StaircaseRule rule = new StaircaseRule(down, 14, 4, 400);
    StimulusLevels ladder = fine(24);
    double slope = 5;
    double told = 2 * rule.target() - 1;
    double target = threshold * Math.pow((1 - told) / told, 1 / slope);
    Random random = new Random(down * 1000L + (long) threshold);
    double[] logs = new double[400];
    for (int i = 0; i < logs.length; i++) {
      Staircase staircase = new Staircase(rule, ladder);
      while (!staircase.over()) {
        double tells = 1 / (1 + Math.pow(ladder.at(staircase.rung()) / threshold, slope));
        staircase.answered(random.nextDouble() < tells + (1 - tells) / 2);
      }
      assertThat(staircase.estimate().kind()).isEqualTo(Kind.FOUND);
      logs[i] = Math.log(staircase.estimate().polygons());
    }
    double mean = Arrays.stream(logs).average().orElseThrow();
    double deviation =
        Math.sqrt(Arrays.stream(logs).map(log -> (log - mean) * (log - mean)).sum() / 399);

    // Within a rung of the target, which is 20 %, and single ones within half as much again.
    assertThat(Math.exp(mean) / target).isCloseTo(1, within(0.15));
    assertThat(deviation).isLessThan(0.4);
  }

  @Test
  void aSeriesGoesUpUntilAnObjectIsNamedTwiceInARow() {
    AscendingSeries series = new AscendingSeries(DOUBLING);

    assertThat(rungs(series, "--+-++")).containsExactly(0, 1, 2, 3, 4, 5);
    assertThat(series.over()).isTrue();
    assertThat(series.estimate()).isEqualTo(new ThresholdEstimate(Kind.FOUND, 160));
  }

  @Test
  void anObjectThatIsNamedAtOnceHasAThresholdBelow() {
    AscendingSeries series = new AscendingSeries(DOUBLING);
    rungs(series, "++");
    assertThat(series.over()).isTrue();
    assertThat(series.estimate()).isEqualTo(new ThresholdEstimate(Kind.BELOW, 10));
  }

  @Test
  void anObjectThatNobodyNamesHasAThresholdAbove() {
    AscendingSeries series = new AscendingSeries(DOUBLING);
    rungs(series, "-------+");
    assertThat(series.over()).isTrue();
    assertThat(series.estimate()).isEqualTo(new ThresholdEstimate(Kind.ABOVE, 1280));
  }

  @Test
  void theVersionsOfALadderRiseByEqualFactors() {
    double[] shares = StimulusLevels.shares(0.01, 4);

    assertThat(shares).hasSize(4);
    assertThat(shares[0]).isCloseTo(0.01, within(1e-12));
    assertThat(
            IntStream.range(1, 4)
                .mapToObj(i -> Math.round(1e6 * shares[i] / shares[i - 1]))
                .collect(Collectors.toSet()))
        .hasSize(1);
    assertThat(1 / shares[3]).isCloseTo(shares[1] / shares[0], within(1e-9));
    assertThatThrownBy(() -> new StimulusLevels(List.of(10, 10, 20)))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
