package org.selectiverenderer.tracker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class LatencyMeterTest {
  @Test
  void tellsMedianAnd99thPercentile() {
    LatencyMeter meter = new LatencyMeter();
    for (int i = 1; i <= 1000; i++) {
      meter.record(i * 10_000L);
    }
    assertThat(meter.count()).isEqualTo(1000);
    assertThat(meter.percentileMs(0.5)).isCloseTo(5, within(0.02));
    assertThat(meter.percentileMs(0.99)).isCloseTo(9.9, within(0.02));
    assertThat(meter.maxMs()).isEqualTo(10);
  }

  @Test
  void isZeroWithoutAnyAndKeepsTheLongest() {
    LatencyMeter meter = new LatencyMeter();
    assertThat(meter.percentileMs(0.99)).isZero();
    meter.record(-5);
    meter.record(3_000_000_000L);
    assertThat(meter.percentileMs(0.25)).isLessThan(0.02);
    assertThat(meter.percentileMs(1)).isCloseTo(100, within(0.02));
    assertThat(meter.maxMs()).isEqualTo(3000);
  }
}
