package org.selectiverenderer.tracker.pipeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerHealth.State;

class TrackerHealthMonitorTest {
  private static final long PERIOD = 8_000_000;
  private final TrackerHealthMonitor meter = new TrackerHealthMonitor();
  private long now = 1_000_000_000;

  @Test
  void rateAndJitterAreThoseOfTheTimesBetweenRecords() {
    for (int i = 0; i < 200; i++) {
      arrive(i % 2 == 0 ? 7_000_000 : 9_000_000);
    }
    assertThat(health().records()).isEqualTo(200);
    assertThat(health().rateHz()).isCloseTo(125, within(2.0));
    assertThat(health().jitterMs()).isCloseTo(1, within(0.02));
    assertThat(health().dropped()).isZero();
  }

  @Test
  void recordsMissingFromARegularStreamAreDropped() {
    regular(100);
    arrive(4 * PERIOD);
    regular(10);
    assertThat(health().dropped()).isEqualTo(3);
  }

  @Test
  void recordsThatComeLateInABunchAreNotDropped() {
    regular(100);
    arrive(4 * PERIOD);
    arrive(0);
    arrive(0);
    arrive(0);
    regular(10);
    assertThat(health().dropped()).isZero();
  }

  @Test
  void aBadRecordIsNotAlsoADroppedOne() {
    regular(100);
    meter.bad();
    arrive(2 * PERIOD);
    regular(10);
    assertThat(health().bad()).isEqualTo(1);
    assertThat(health().dropped()).isZero();
  }

  @Test
  void aPauseOfTheConnectionDropsNothing() {
    regular(100);
    meter.pause();
    arrive(500 * PERIOD);
    regular(100);
    assertThat(health().dropped()).isZero();
    assertThat(health().rateHz()).isCloseTo(125, within(0.1));
  }

  private void regular(int records) {
    for (int i = 0; i < records; i++) {
      arrive(PERIOD);
    }
  }

  private void arrive(long after) {
    now += after;
    meter.good(now);
  }

  private TrackerHealth health() {
    return meter.health(State.STREAMING, now);
  }
}
