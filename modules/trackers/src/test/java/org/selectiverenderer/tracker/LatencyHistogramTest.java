package org.selectiverenderer.tracker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LatencyHistogramTest {
  @Test
  void tellsMedianAnd99thPercentile() {
    LatencyHistogram meter = new LatencyHistogram();
    for (int i = 1; i <= 1000; i++) {
      meter.record(i * 10_000L);
    }
    assertThat(meter.count()).isEqualTo(1000);
    assertThat(meter.percentileMs(0.5)).isCloseTo(5, withinPercentage(0.5));
    assertThat(meter.percentileMs(0.99)).isCloseTo(9.9, withinPercentage(0.5));
    assertThat(meter.maxMs()).isEqualTo(10);
  }

  @Test
  void isZeroWithoutAnyAndKeepsTheLongest() {
    LatencyHistogram meter = new LatencyHistogram();
    assertThat(meter.percentileMs(0.99)).isZero();
    meter.record(-5);
    meter.record(3_000_000_000L);
    assertThat(meter.percentileMs(0.25)).isCloseTo(0, within(0.001));
    assertThat(meter.percentileMs(1)).isEqualTo(3000);
    assertThat(meter.maxMs()).isEqualTo(3000);
  }

  @Test
  void hasNoEndThatItWouldTellAsAPercentile() {
    LatencyHistogram meter = new LatencyHistogram();
    for (int i = 0; i < 100; i++) {
      meter.record(250_000_000L);
    }
    meter.record(Long.MAX_VALUE);
    assertThat(meter.percentileMs(0.5)).isCloseTo(250, withinPercentage(0.5));
    assertThat(meter.percentileMs(0.99)).isCloseTo(250, withinPercentage(0.5));
    assertThat(meter.percentileMs(1)).isEqualTo(Long.MAX_VALUE * 1e-6);
  }

  @Test
  void isRightToHalfAPercentFromMicrosecondsToMinutes() {
    Random random = new Random(5);
    LatencyHistogram meter = new LatencyHistogram();
    long[] nanos = new long[20_000];
    for (int i = 0; i < nanos.length; i++) {
      nanos[i] = (long) Math.pow(10, 5 + 6 * random.nextDouble());
      meter.record(nanos[i]);
    }
    Arrays.sort(nanos);
    for (int percent = 1; percent <= 100; percent++) {
      double exact = nanos[nanos.length * percent / 100 - 1] * 1e-6;
      assertThat(meter.percentileMs(percent / 100.0)).isCloseTo(exact, withinPercentage(0.51));
    }
  }
}
