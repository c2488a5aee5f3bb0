package org.selectiverenderer.runtime.render.show;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FrameTimesTest {
  @Test
  void percentilesAreNearestRanks() {
    FrameTimes times = new FrameTimes(1000);
    for (int ms = 100; ms >= 1; ms--) {
      times.add(ms);
    }
    FrameTimes.Summary summary = times.summary();
    assertThat(summary)
        .isEqualTo(new FrameTimes.Summary(100, 50.5, 50, 95, 99, 100, summary.kept()));
    assertThat(summary.framesPerSecond()).isEqualTo(1000 / 50.5);
  }

  @Test
  void aLongRunKeepsTheLatestForPercentilesAndAllForTheRest() {
    FrameTimes times = new FrameTimes(2);
    times.add(90);
    times.add(3);
    times.add(6);
    assertThat(times.summary())
        .isEqualTo(new FrameTimes.Summary(3, 33, 3, 6, 6, 90, FrameTimes.Sorted.of(6, 3)));
  }

  @Test
  void theShareOfSlowFramesCountsThoseThatTookLonger() {
    FrameTimes times = new FrameTimes(10);
    for (int ms : new int[] {10, 40, 33, 34}) {
      times.add(ms);
    }
    assertThat(times.summary().shareAbove(33)).isEqualTo(0.5);
    assertThat(times.summary().shareAbove(Double.POSITIVE_INFINITY)).isZero();
    assertThat(new FrameTimes(1).summary().shareAbove(33)).isZero();
  }

  @Test
  void withoutAFrameEverythingIsZero() {
    assertThat(new FrameTimes(4).summary())
        .isEqualTo(new FrameTimes.Summary(0, 0, 0, 0, 0, 0, FrameTimes.Sorted.of()));
    assertThat(new FrameTimes(4).summary().framesPerSecond()).isZero();
  }
}
