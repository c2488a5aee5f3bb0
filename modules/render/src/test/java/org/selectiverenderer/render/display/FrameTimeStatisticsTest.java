package org.selectiverenderer.render.display;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class FrameTimeStatisticsTest {
  @Test
  void percentilesAreNearestRanks() {
    FrameTimeStatistics times = new FrameTimeStatistics(1000);
    for (int ms = 100; ms >= 1; ms--) {
      times.add(ms);
    }
    FrameTimeStatistics.Summary summary = times.summary();
    assertThat(summary)
        .isEqualTo(new FrameTimeStatistics.Summary(100, 50.5, 50, 95, 99, 100, summary.kept()));
    assertThat(summary.framesPerSecond()).isEqualTo(1000 / 50.5);
  }

  @Test
  void aLongRunKeepsTheLatestForPercentilesAndAllForTheRest() {
    FrameTimeStatistics times = new FrameTimeStatistics(2);
    times.add(90);
    times.add(3);
    times.add(6);
    assertThat(times.summary())
        .isEqualTo(
            new FrameTimeStatistics.Summary(
                3, 33, 3, 6, 6, 90, FrameTimeStatistics.Sorted.of(6, 3)));
  }

  @Test
  void theShareOfSlowFramesCountsThoseThatTookLonger() {
    FrameTimeStatistics times = new FrameTimeStatistics(10);
    for (int ms : new int[] {10, 40, 33, 34}) {
      times.add(ms);
    }
    assertThat(times.summary().shareAbove(33)).isEqualTo(0.5);
    assertThat(times.summary().shareAbove(Double.POSITIVE_INFINITY)).isZero();
    assertThat(new FrameTimeStatistics(1).summary().shareAbove(33)).isZero();
  }

  @Test
  void withoutAFrameEverythingIsZero() {
    assertThat(new FrameTimeStatistics(4).summary())
        .isEqualTo(
            new FrameTimeStatistics.Summary(0, 0, 0, 0, 0, 0, FrameTimeStatistics.Sorted.of()));
    assertThat(new FrameTimeStatistics(4).summary().framesPerSecond()).isZero();
  }
}
