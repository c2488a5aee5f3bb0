package org.selectiverenderer.browser.nodes.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.scene.Node;

class TimeSensorTest {
  private final TestNodes nodes = new TestNodes();
  private final TestFrameContext frame = new TestFrameContext();

  private TimeSensorNode clock(Object... fields) {
    return (TimeSensorNode) nodes.watch(nodes.node("TimeSensor", fields));
  }

  private void at(TimeSensorNode clock, double time) {
    frame.step(clock, time, nodes.cascade);
  }

  @Test
  void aRunGoesFromItsStartToTheEndOfItsCycle() {
    TimeSensorNode clock = clock("startTime", 10.0, "cycleInterval", 4.0);
    at(clock, 9);
    assertThat(nodes.sent()).isEmpty();
    at(clock, 11);
    assertThat(nodes.sent())
        .containsExactly(
            "isActive=true",
            "cycleTime=10.0",
            "elapsedTime=1.0",
            "fraction_changed=0.25",
            "time=11.0");
    at(clock, 15);
    assertThat(nodes.sent())
        .containsExactly("elapsedTime=4.0", "fraction_changed=1.0", "time=15.0", "isActive=false");
    at(clock, 16);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void anAnimationRateLetsAClockSendSoManyFractionsASecond() {
    Node rate = nodes.node("MetadataDouble", "name", "animationRate", "value", new double[] {2});
    TimeSensorNode clock =
        clock("loop", true, "startTime", 10.0, "cycleInterval", 4.0, "metadata", rate);
    at(clock, 10);
    assertThat(nodes.sent()).contains("fraction_changed=0.0");
    at(clock, 10.25);
    assertThat(nodes.sent()).containsExactly("elapsedTime=0.25", "time=10.25");
    at(clock, 10.5);
    assertThat(nodes.sent()).contains("fraction_changed=0.125");
    at(clock, 10.75);
    assertThat(nodes.sent()).doesNotContain("fraction_changed=0.1875");
    nodes.send(rate, "value", new double[] {0});
    nodes.sent();
    at(clock, 11);
    assertThat(nodes.sent()).as("stands still").containsExactly("elapsedTime=1.0", "time=11.0");
    nodes.send(rate, "value", new double[] {100});
    nodes.sent();
    at(clock, 11.5);
    assertThat(nodes.sent()).contains("fraction_changed=0.375");
  }

  @Test
  void aClockWithARateSendsTheEndOfItsOnlyCycle() {
    Node rate = nodes.node("MetadataDouble", "name", "animationRate", "value", new double[] {0.1});
    TimeSensorNode clock = clock("startTime", 10.0, "cycleInterval", 4.0, "metadata", rate);
    at(clock, 11);
    at(clock, 12);
    nodes.sent();
    at(clock, 15);
    assertThat(nodes.sent()).contains("fraction_changed=1.0");
  }

  @Test
  void theDefaultsDoNotRunWhenTheWorldBeginsLater() {
    TimeSensorNode clock = clock();
    at(clock, 1_700_000_000);
    at(clock, 1_700_000_001);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aRunThatLiesBetweenTwoFramesIsRunInTheLaterOne() {
    TimeSensorNode clock = clock("startTime", 10.0, "cycleInterval", 0.01);
    at(clock, 9.99);
    at(clock, 10.2);
    assertThat(nodes.sent())
        .containsExactly(
            "isActive=true",
            "cycleTime=10.0",
            "elapsedTime=0.01",
            "fraction_changed=1.0",
            "time=10.2",
            "isActive=false");
    at(clock, 10.3);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aLoopSendsTheTimeOfEachCycleAndTheFractionOneAtItsEnd() {
    TimeSensorNode clock = clock("loop", true, "startTime", 10.0, "cycleInterval", 2.0);
    at(clock, 10);
    assertThat(nodes.sent()).contains("cycleTime=10.0", "fraction_changed=0.0");
    at(clock, 12);
    assertThat(nodes.sent()).contains("cycleTime=12.0", "fraction_changed=1.0");
    at(clock, 12.5);
    assertThat(nodes.sent())
        .containsExactly("elapsedTime=2.5", "fraction_changed=0.25", "time=12.5");
    at(clock, 19);
    assertThat(nodes.sent()).contains("cycleTime=18.0", "fraction_changed=0.5");
  }

  @Test
  void aLoopThatIsTakenAwayEndsWithItsCycle() {
    TimeSensorNode clock = clock("loop", true, "startTime", 0.0, "cycleInterval", 2.0);
    at(clock, 5);
    nodes.send(clock, "loop", false);
    nodes.sent();
    at(clock, 5.5);
    assertThat(clock.active()).isTrue();
    nodes.sent();
    at(clock, 6.5);
    assertThat(nodes.sent())
        .containsExactly("elapsedTime=6.0", "fraction_changed=1.0", "time=6.5", "isActive=false");
  }

  @Test
  void stopTimeEndsARunAndOneNotAfterTheStartIsIgnored() {
    TimeSensorNode clock = clock("loop", true, "startTime", 10.0, "cycleInterval", 4.0);
    at(clock, 10);
    nodes.send(clock, "stopTime", 5.0);
    assertThat(clock.value("stopTime")).isEqualTo(0.0);
    nodes.send(clock, "stopTime", 11.0);
    nodes.sent();
    at(clock, 12);
    assertThat(nodes.sent())
        .containsExactly("elapsedTime=1.0", "fraction_changed=0.25", "time=12.0", "isActive=false");
    at(clock, 13);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aRunningClockIgnoresStartTimeAndCycleInterval() {
    TimeSensorNode clock = clock("loop", true, "startTime", 1.0);
    at(clock, 2);
    nodes.sent();
    nodes.send(clock, "startTime", 50.0);
    nodes.send(clock, "cycleInterval", 50.0);
    assertThat(nodes.sent()).isEmpty();
    assertThat(clock.value("startTime")).isEqualTo(1.0);
    assertThat(clock.value("cycleInterval")).isEqualTo(1.0);
  }

  @Test
  void disablingSendsWhereTheClockStandsAndEndsIt() {
    TimeSensorNode clock = clock("startTime", 10.0, "cycleInterval", 4.0);
    at(clock, 10);
    nodes.sent();
    nodes.cascade.at(11);
    nodes.send(clock, "enabled", false);
    assertThat(nodes.sent())
        .containsExactly(
            "enabled=false",
            "elapsedTime=1.0",
            "fraction_changed=0.25",
            "time=11.0",
            "isActive=false");
    at(clock, 12);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aPauseStopsTheClockAndCountsForNothing() {
    TimeSensorNode clock = clock("startTime", 10.0, "cycleInterval", 4.0);
    at(clock, 10);
    nodes.sent();
    nodes.send(clock, "pauseTime", 11.0);
    nodes.sent();
    at(clock, 12);
    assertThat(nodes.sent())
        .containsExactly("elapsedTime=1.0", "fraction_changed=0.25", "time=12.0", "isPaused=true");
    at(clock, 50);
    assertThat(nodes.sent()).isEmpty();
    nodes.send(clock, "resumeTime", 51.0);
    nodes.sent();
    at(clock, 52);
    assertThat(nodes.sent())
        .containsExactly("isPaused=false", "elapsedTime=2.0", "fraction_changed=0.5", "time=52.0");
    at(clock, 54);
    assertThat(nodes.sent()).contains("fraction_changed=1.0", "isActive=false");
  }

  @Test
  void stoppingAPausedClockEndsThePause() {
    TimeSensorNode clock = clock("loop", true, "startTime", 10.0, "pauseTime", 11.0);
    at(clock, 12);
    nodes.send(clock, "stopTime", 13.0);
    nodes.sent();
    at(clock, 14);
    assertThat(nodes.sent()).containsExactly("isPaused=false", "isActive=false");
  }

  @Test
  void aTouchStartsAClockThroughARoute() {
    TouchSensorNode touch = (TouchSensorNode) nodes.node("TouchSensor");
    TimeSensorNode clock = clock("cycleInterval", 2.0);
    nodes.route(touch, "touchTime", clock, "startTime");
    at(clock, 100);
    nodes.cascade.emit(touch, touch.type().indexOf("touchTime"), 100.0);
    nodes.sent();
    at(clock, 101);
    assertThat(nodes.sent()).contains("isActive=true", "cycleTime=100.0", "fraction_changed=0.5");
  }

  @Test
  void anIntervalThatIsNotPositiveNeverRuns() {
    TimeSensorNode clock = clock("loop", true, "cycleInterval", 0.0);
    at(clock, 1);
    TimeSensorNode negative = clock("loop", true, "cycleInterval", -1.0);
    at(negative, 1);
    assertThat(nodes.sent()).isEmpty();
  }

  @Test
  void aClockThatItsOwnEventDisablesEndsAtTheNextFrame() {
    TimeSensorNode clock = clock("loop", true);
    Node not = nodes.node("BooleanFilter");
    nodes.route(clock, "isActive", not, "set_boolean");
    nodes.route(not, "inputNegate", clock, "enabled");
    at(clock, 5);
    at(clock, 6);
    assertThat(clock.active()).isFalse();
  }
}
