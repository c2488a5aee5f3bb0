package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerHealth.State;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.HeadMotion;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator.Settings;
import org.selectiverenderer.tracker.emulator.PseudoTerminal.Maker;
import org.selectiverenderer.tracker.factory.TrackerFactory;

/** The real driver on a real serial device (a pseudo-terminal), the emulator at the far end. */
class InterTrax2Test {
  private static final HeadMotion STILL = (t, into) -> into.turn(90, -45, 10);
  private static final double STEP = 180.0 / 32768;

  @TempDir Path folder;
  private final RecordingTrackerListener watching = new RecordingTrackerListener();
  private final PoseSample pose = new PoseSample();
  private Path link;

  @BeforeEach
  void needsATerminal() {
    assumeTrue(Stream.of(Maker.values()).anyMatch(Maker::installed), "no socat, no script");
    link = folder.resolve("tracker");
  }

  @Test
  void theHeadLooksWhereTheDeviceSays() throws IOException {
    try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(link, new Settings(120, STILL));
        HeadTracker tracker = open(device)) {
      watching.more(20);
      assertThat(tracker.read(pose)).isTrue();
      assertThat(pose.yaw()).isCloseTo(90, within(STEP));
      assertThat(pose.pitch()).isCloseTo(-45, within(STEP));
      assertThat(pose.roll()).isCloseTo(10, within(STEP));
      assertThat(tracker.health().state()).isEqualTo(State.STREAMING);
      assertThat(tracker.health().bad()).isZero();
      assertThat(watching.messages()).isEmpty();
    }
  }

  @Test
  void anotherStartFindsItStreaming() throws IOException {
    try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(link, new Settings(480, STILL))) {
      for (int run = 0; run < 3; run++) {
        try (HeadTracker tracker = open(device)) {
          watching.more(50);
          assertThat(tracker.read(pose)).isTrue();
          assertThat(pose.yaw()).isCloseTo(90, within(STEP));
        }
      }
      assertThat(watching.messages()).isEmpty();
    }
  }

  @Test
  void theCableMayBePulledAndPluggedInAgain() throws IOException {
    try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(link, new Settings(120, STILL));
        HeadTracker tracker = open(device)) {
      for (int round = 1; round <= 2; round++) {
        watching.more(10);
        device.unplug();
        watching.until("the loss", () -> tracker.health().state() == State.LOST);
        assertThat(tracker.health().stale()).isTrue();
        assertThat(tracker.read(pose)).as("the last pose stays").isTrue();
        device.plug();
        watching.more(10);
        assertThat(tracker.health().reconnects()).isEqualTo(round);
      }
      assertThat(tracker.health().dropped()).isZero();
      watching.problem("records arrive again, after");
      assertThat(watching.messages())
          .filteredOn(message -> message.contains("has disappeared (was the cable pulled?)"))
          .hasSize(2);
    }
  }

  @Test
  void theHeadingIsResetInSoftware() throws IOException {
    try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(link, new Settings(120, STILL));
        HeadTracker tracker = open(device)) {
      watching.more(5);
      tracker.resetHeading();
      assertThat(tracker.read(pose)).isTrue();
      assertThat(pose.yaw()).isZero();
      assertThat(pose.pitch()).as("gravity tells it").isCloseTo(-45, within(STEP));
    }
  }

  @Test
  void aHeadingResetBeforeTheFirstRecordTakesThatOne() throws IOException {
    try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(link, new Settings(120, STILL));
        HeadTracker tracker = open(device)) {
      tracker.resetHeading();
      watching.more(5);
      assertThat(tracker.read(pose)).isTrue();
      assertThat(pose.yaw()).isZero();
    }
  }

  @Test
  void closingEndsTheThreadAndLetsGoOfThePort() throws IOException {
    try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(link, new Settings(120, STILL))) {
      HeadTracker tracker = open(device);
      try (tracker) {
        watching.more(5);
      }
      assertThat(tracker.health().state()).isEqualTo(State.CLOSED);
      assertThat(Thread.getAllStackTraces().keySet())
          .extracting(Thread::getName)
          .doesNotContain("tracker-intertrax2");
    }
  }

  private HeadTracker open(EmulatedInterTrax2 device) throws IOException {
    return TrackerFactory.open(
        new TrackerSpec.InterTrax2(device.link().toString()), TrackerOptions.NONE, watching);
  }
}
