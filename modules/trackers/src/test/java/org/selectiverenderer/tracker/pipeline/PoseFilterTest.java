package org.selectiverenderer.tracker.pipeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.tracker.EulerAngle;
import org.selectiverenderer.tracker.Orientation;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerOptions.Smoothing;
import org.selectiverenderer.tracker.TrackerOptions.Swap;

class PoseFilterTest {
  private static final double HZ = 120;
  private final PoseSample sample = new PoseSample();
  private long records;

  @Test
  void withoutOptionsRecordsStayAsTheyCome() {
    PoseFilter filter = PoseFilter.of(TrackerOptions.NONE);
    assertThat(filtered(filter, 10, -20, 30)).isEqualTo(new Orientation(10, -20, 30));
  }

  @Test
  void anglesAreSwappedFirstAndInvertedThen() {
    PoseFilter filter =
        PoseFilter.of(
            new TrackerOptions(
                Optional.of(new Swap(EulerAngle.PITCH, EulerAngle.ROLL)),
                Set.of(EulerAngle.YAW, EulerAngle.PITCH),
                Optional.empty(),
                0));
    assertThat(filtered(filter, 10, 20, 30)).isEqualTo(new Orientation(-10, -30, 20));
  }

  @Test
  void smoothingCalmsAHeadAtRest() {
    PoseFilter filter = smoothing();
    Random random = new Random(4);
    double raw = 0;
    double smooth = 0;
    for (int i = 0; i < 1200; i++) {
      double noise = 0.1 * random.nextGaussian();
      Orientation told = filtered(filter, 40 + noise, 0, 0);
      if (i > 120) {
        raw += noise * noise;
        smooth += Math.pow(told.yaw() - 40, 2);
      }
    }
    assertThat(Math.sqrt(smooth)).isLessThan(0.5 * Math.sqrt(raw));
  }

  @Test
  void smoothingFollowsATurnAndPassesTheBack() {
    PoseFilter filter = smoothing();
    double worst = 0;
    for (int i = 0; i < 240; i++) {
      double yaw = 100 + 100 * i / HZ; // 100 degrees per second, past 180.
      Orientation told = filtered(filter, yaw, 0, 0);
      if (i > 60) {
        worst = Math.max(worst, Math.abs(Math.IEEEremainder(yaw - told.yaw(), 360)));
      }
    }
    // 2 degrees at 100 degrees per second are 20 ms.
    assertThat(worst).isLessThan(2);
  }

  @Test
  void aSteadyTurnIsPredictedExactly() {
    PoseFilter filter =
        PoseFilter.of(new TrackerOptions(Optional.empty(), Set.of(), Optional.empty(), 0.05));
    Orientation told = new Orientation(0, 0, 0);
    double yaw = 0;
    for (int i = 0; i < 60; i++) {
      yaw = 150 + 90 * i / HZ;
      told = filtered(filter, yaw, 0, 0);
    }
    assertThat(Math.IEEEremainder(told.yaw() - (yaw + 90 * 0.05), 360)).isCloseTo(0, within(1e-6));
    assertThat(told.pitch()).isCloseTo(0, within(1e-6));
  }

  @Test
  void aHeadAtRestIsPredictedWhereItIsEvenWhenRecordsComeInBunches() {
    PoseFilter filter =
        PoseFilter.of(new TrackerOptions(Optional.empty(), Set.of(), Optional.empty(), 0.1));
    for (int i = 0; i < 400; i++) {
      sample.set(i + 1L, i / 8 * 16_000_000L, 33, -12, 4);
      filter.apply(sample);
      assertThat(sample.yaw()).isCloseTo(33, within(1e-6));
      assertThat(sample.pitch()).isCloseTo(-12, within(1e-6));
      assertThat(sample.roll()).isCloseTo(4, within(1e-6));
    }
  }

  @Test
  void aPredictionLongerThanAHeadsMovementIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new TrackerOptions(Optional.empty(), Set.of(), Optional.empty(), 0.2))
        .withMessageContaining("between 0 and 100 ms");
  }

  private PoseFilter smoothing() {
    return PoseFilter.of(
        new TrackerOptions(Optional.empty(), Set.of(), Optional.of(Smoothing.DEFAULT), 0));
  }

  private Orientation filtered(PoseFilter filter, double yaw, double pitch, double roll) {
    records++;
    sample.set(records, (long) (records / HZ * 1e9), yaw, pitch, roll);
    filter.apply(sample);
    return sample.orientation();
  }
}
