package org.selectiverenderer.study.gaze;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.study.gaze.ConsistencyEstimate.Evidence;
import org.selectiverenderer.study.gaze.CrossedEffectsModel.Fit;
import org.selectiverenderer.study.gaze.CrossedEffectsModel.Observation;

/** The pieces of the estimate on data with answers known by hand. */
class ConsistencyEstimateTest {
  private static final GazeArea AREA = new GazeArea("OfficeSchema", true);

  private static ConsistencyEstimate estimate(double attention, double deviation, int people) {
    return new ConsistencyEstimate(
        "Cup", AREA, attention, deviation, OptionalDouble.empty(), new Evidence(people, 9, 3, 4));
  }

  @Test
  void theDegreeIsALogisticFunctionOfAttention() {
    assertThat(estimate(0, 1, 9).degree()).isEqualTo(0.5);
    assertThat(estimate(Math.log(2), 1, 9).degree()).isCloseTo(1 / 9.0, within(1e-12));
    assertThat(estimate(-Math.log(2), 1, 9).degree()).isCloseTo(8 / 9.0, within(1e-12));
  }

  @Test
  void theIntervalHoldsTheMiddleNinetyPercent() {
    ConsistencyEstimate estimate = estimate(0, 0.5, 9);
    assertThat(estimate.low()).isCloseTo(1 / (1 + Math.exp(3 * 0.8224)), within(1e-4));
    assertThat(estimate.high()).isCloseTo(1 - estimate.low(), within(1e-12));
  }

  @Test
  void theTypeIsSaidOnlyWhereTheIntervalLiesOnOneSideOfOneHalf() {
    assertThat(estimate(0.5, 0.3, 9).type()).contains(ConsistencyType.INCONSISTENT);
    assertThat(estimate(-0.5, 0.3, 9).type()).contains(ConsistencyType.CONSISTENT);
    assertThat(estimate(0.5, 0.31, 9).type()).isEmpty();
    assertThat(estimate(0.5, 0.1, 1).type()).as("one participant's interest").isEmpty();
  }

  @Test
  void aRatingLetsExpectTheAttentionOfItsDegree() {
    assertThat(ConsistencyEstimate.expectedAttention(3.5)).isCloseTo(0, within(1e-12));
    double expected = ConsistencyEstimate.expectedAttention(2);
    assertThat(estimate(expected, 1, 9).degree()).isCloseTo(0.2, within(1e-12));
    // The ends are not certain.
    assertThat(estimate(ConsistencyEstimate.expectedAttention(6), 1, 9).degree())
        .isCloseTo(0.9, within(1e-12));
  }

  @Test
  void attentionIsComparedWithWhatTimeInViewLetsExpect() {
    // Two objects of one size with the same 10 s in which they could be looked at. The cup has 6 of
    // 8 looks and 6 of 8 s of dwell, 4 of each were to be expected; both were found at once.
    ParticipantAttention seen =
        new ParticipantAttention(
            "p",
            AREA,
            Map.of(
                "Cup", new ObjectAttention(16, 16 * 0.01, 1, 1, 6, 6, 6),
                "Pen", new ObjectAttention(12, 12 * 0.01, 1, 1, 2, 2, 2)));
    double expected = 0.75 * Math.log(6.5 / 4.5) / 0.75;
    assertThat(relativeAttention(seen, "Cup", 1)).isCloseTo(expected, within(1e-12));
    assertThat(expectedLooks(seen, "Cup", 1)).isCloseTo(4, within(1e-12));
    assertThat(relativeAttention(seen, "Pen", 1)).isCloseTo(Math.log(2.5 / 4.5), within(1e-12));
  }

  @Test
  void aLargerObjectIsExpectedToDrawMore() {
    Map<String, ObjectAttention> objects =
        Map.of(
            "Large", new ObjectAttention(16, 16 * 0.09, 1, 1, 6, 6, 6),
            "Small", new ObjectAttention(12, 12 * 0.01, 1, 1, 2, 2, 2));
    ParticipantAttention seen = new ParticipantAttention("p", AREA, objects);
    assertThat(expectedLooks(seen, "Large", 0.5)).isCloseTo(6, within(1e-12));
    assertThat(relativeAttention(seen, "Large", 0.5))
        .isLessThan(relativeAttention(seen, "Large", 0));
  }

  @Test
  void anObjectHardlyInViewIsLeftOut() {
    ParticipantAttention seen =
        new ParticipantAttention(
            "p", AREA, Map.of("Cup", new ObjectAttention(0.9, 0.1, 0, 0, 0, 0, 0)));
    assertThat(seen.objects()).isEmpty();
  }

  private static double relativeAttention(
      ParticipantAttention seen, String object, double exponent) {
    return seen.relativeAttention(
        Objects.requireNonNull(seen.objects().get(object)), seen.totals(exponent));
  }

  private static double expectedLooks(ParticipantAttention seen, String object, double exponent) {
    return seen.expectedLooks(
        Objects.requireNonNull(seen.objects().get(object)), seen.totals(exponent));
  }

  /** Four objects seen by eight participants; effects are -1, 0, 0 and 1. */
  private static List<Observation> balanced() {
    double[] effects = {-1, 0, 0, 1};
    List<Observation> data = new ArrayList<>();
    for (int p = 0; p < 8; p++) {
      for (int o = 0; o < 4; o++) {
        double error = 0.1 * ((p + o) % 2 == 0 ? 1 : -1);
        data.add(new Observation(o, p, 0, 0, 5 + effects[o] + 0.2 * (p % 4) + error, 1));
      }
    }
    return data;
  }

  @Test
  void effectsOfBalancedDataAreShrunkAlikeTowardsTheirMean() {
    Fit fit = CrossedEffectsModel.fit(balanced());
    assertThat(fit.objects()[0]).isBetween(-1.0, -0.9);
    assertThat(fit.objects()[3]).isCloseTo(-fit.objects()[0], within(1e-4));
    assertThat(fit.objects()[1]).isCloseTo(0, within(1e-4));
    assertThat(fit.deviations()[0]).isCloseTo(fit.deviations()[2], within(1e-9));
    assertThat(fit.spread()).isBetween(0.5, 1.0);
  }

  @Test
  void whatIsSeenLittleIsShrunkMore() {
    List<Observation> data = balanced();
    data.removeIf(each -> each.object() == 3 && each.participant() > 0);
    Fit fit = CrossedEffectsModel.fit(data);
    assertThat(Math.abs(fit.objects()[3])).isLessThan(Math.abs(fit.objects()[0]) - 0.1);
    assertThat(fit.deviations()[3]).isGreaterThan(1.05 * fit.deviations()[0]);
  }

  @Test
  void whatFollowsFromSizeIsTheSlopeAndNoEffectOfObjects() {
    List<Observation> data = new ArrayList<>();
    for (int p = 0; p < 6; p++) {
      for (int o = 0; o < 12; o++) {
        double error = 0.1 * ((p + o) % 2 == 0 ? 1 : -1);
        data.add(new Observation(o, p, 0, o / 4.0, 1.5 * o / 4.0 + error, 1));
      }
    }
    Fit fit = CrossedEffectsModel.fit(data);
    assertThat(fit.slope()).isCloseTo(1.5, within(0.15));
    for (double effect : fit.objects()) {
      assertThat(effect).isBetween(-0.2, 0.2);
    }
  }

  /** A tenth of the limits: 200 participants saw half of 200 objects in 10 areas. */
  @Test
  void manyObjectsInManyAreasAreEstimated() {
    int participants = 200;
    int areas = 10;
    int objects = 200;
    Random random = new Random(3);
    double[] effects = random.doubles(objects, -1, 1).toArray();
    List<Observation> data = new ArrayList<>();
    for (int p = 0; p < participants; p++) {
      double own = 0.2 * random.nextGaussian();
      for (int k = 0; k < objects; k++) {
        double x = random.nextGaussian();
        double y = k % areas + 0.3 * x + effects[k] + own + 0.5 * random.nextGaussian();
        if ((p + k / areas) % 2 == 0) {
          data.add(new Observation(k, p, k % areas, x, y, 1));
        }
      }
    }

    Fit fit = CrossedEffectsModel.fit(data);

    assertThat(fit.slope()).isCloseTo(0.3, within(0.02));
    for (int k = 0; k < objects; k++) {
      double mean = 0; // effects are relative to those of the same area
      for (int other = k % areas; other < objects; other += areas) {
        mean += effects[other] * areas / objects;
      }
      assertThat(fit.objects()[k]).isCloseTo(effects[k] - mean, within(0.3));
      assertThat(fit.deviations()[k]).isBetween(0.03, 0.3);
    }
  }
}
