package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class WorldClockTest {
  /** X3D counts time from 1970: a startTime of 0, the default, is long past when a world begins. */
  @Test
  void aClockThatNobodyStartsRestsWhenTheWorldBegins() {
    try (WorldFixture fixture =
        new WorldFixture("<TimeSensor DEF='Clock' cycleInterval='0.5'/><Group/>")) {
      fixture.world.epoch(World.EPOCH);
      fixture.step(0);
      fixture.step(0.1);
      assertThat(fixture.node("Clock").bool("isActive")).isFalse();
    }
  }

  @Test
  void aClockInALoopRunsFromTheStart() {
    try (WorldFixture fixture = new WorldFixture("<TimeSensor DEF='Clock' loop='true'/><Group/>")) {
      fixture.world.epoch(World.EPOCH);
      fixture.step(0);
      assertThat(fixture.node("Clock").bool("isActive")).isTrue();
    }
  }
}
