package org.selectiverenderer.app.clock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class FixedRateScheduleTest {

  @Test
  void bothEndsOfThePathAreFrames() {
    FixedRateSchedule clock = new FixedRateSchedule(0, 5, 60);
    assertThat(clock.frames()).isEqualTo(301);
    assertThat(clock.time(0)).isZero();
    assertThat(clock.time(300)).isEqualTo(5);
  }

  @Test
  void aPathThatIsARoundingErrorShortOfAFrameHasIt() {
    assertThat(new FixedRateSchedule(0, 0.1 + 0.2 - 1e-12, 10).frames()).isEqualTo(4);
    assertThat(new FixedRateSchedule(100.1, 100.4, 10).frames()).isEqualTo(4);
  }

  @Test
  void whatIsLeftOfADurationIsNoFrame() {
    assertThat(new FixedRateSchedule(0, 1.99, 1).frames()).isEqualTo(2);
  }

  @Test
  void aPathOfOneMomentHasOneFrame() {
    FixedRateSchedule clock = new FixedRateSchedule(3, 3, 60);
    assertThat(clock.frames()).isEqualTo(1);
    assertThat(clock.time(0)).isEqualTo(3);
  }

  @Test
  void timeStartsWhereThePathDoes() {
    FixedRateSchedule clock = new FixedRateSchedule(-2, 0, 4);
    assertThat(clock.frames()).isEqualTo(9);
    assertThat(clock.time(1)).isEqualTo(-1.75);
  }

  @Test
  void timeDoesNotRunBackwards() {
    assertThatThrownBy(() -> new FixedRateSchedule(1, 0, 60))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new FixedRateSchedule(0, 1, 0))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new FixedRateSchedule(0, Double.NaN, 60))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
