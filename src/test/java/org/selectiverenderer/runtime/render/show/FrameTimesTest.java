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
    assertThat(summary).isEqualTo(new FrameTimes.Summary(100, 50.5, 50, 95, 99, 100));
    assertThat(summary.framesPerSecond()).isEqualTo(1000 / 50.5);
  }

  @Test
  void aLongRunKeepsTheLatestForPercentilesAndAllForTheRest() {
    FrameTimes times = new FrameTimes(2);
    times.add(90);
    times.add(3);
    times.add(6);
    assertThat(times.summary()).isEqualTo(new FrameTimes.Summary(3, 33, 3, 6, 6, 90));
  }

  @Test
  void withoutAFrameEverythingIsZero() {
    assertThat(new FrameTimes(4).summary()).isEqualTo(new FrameTimes.Summary(0, 0, 0, 0, 0, 0));
    assertThat(new FrameTimes(4).summary().framesPerSecond()).isZero();
  }
}
