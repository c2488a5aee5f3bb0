package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

/** Devices in all states, and other devices, at the far end of the cable. */
class InterTrax2HandshakeTest {
  private static final byte[] RECORD = HexFormat.of().parseHex("80004000E001005F");

  @TempDir Path folder;
  private final RecordingTrackerListener watching = new RecordingTrackerListener();

  @Test
  void commandsComeInTheirOrder() throws IOException {
    try (FakeSerialDevice device = new FakeSerialDevice(link(), this::obeys);
        HeadTracker tracker = open()) {
      watching.more(2);
      assertThat(device.heard()).isEqualTo("ct\2b\4d");
      assertThat(tracker.health().bad()).isZero();
    }
  }

  @Test
  void anExclamationMarkAndAByteIsAnAnswerToo() throws IOException {
    try (FakeSerialDevice device =
            new FakeSerialDevice(
                link(),
                (command, far) -> {
                  if (command == 'c') {
                    far.says('!', 'x');
                  } else {
                    obeys(command, far);
                  }
                });
        HeadTracker tracker = open()) {
      watching.more(2);
      assertThat(device.heard()).isEqualTo("ct\2b\4d");
      assertThat(tracker.health().bad()).isZero();
    }
  }

  @Test
  void aHungDeviceIsReset() throws IOException {
    StringBuilder heard = new StringBuilder();
    try (FakeSerialDevice device =
            new FakeSerialDevice(
                link(),
                (command, far) -> {
                  if (heard.indexOf("*reset") >= 0) {
                    obeys(command, far);
                  }
                  heard.append((char) command);
                });
        HeadTracker tracker = open()) {
      watching.more(2);
      assertThat(device.heard()).isEqualTo("cccc*resetct\2b\4d");
      assertThat(tracker.health().bad()).isZero();
    }
  }

  @Test
  void aSilentDeviceIsReportedOnceAndAskedOn() throws IOException {
    AtomicInteger resets = new AtomicInteger();
    try (FakeSerialDevice device =
            new FakeSerialDevice(
                link(),
                (command, far) -> {
                  if (command == '*') {
                    resets.incrementAndGet();
                  }
                });
        HeadTracker tracker = open()) {
      watching.until("two more attempts", () -> resets.get() >= 3);
      assertThat(device.heard()).startsWith("cccc*reset");
      assertThat(watching.messages())
          .containsExactly(
              "no InterTrax2 answers (is it plugged in and powered?); the program "
                  + "keeps trying until it answers");
      assertThat(tracker.health().records()).isZero();
    }
  }

  @Test
  void garbageIsReportedAsAnotherSpeedOrDevice() throws IOException {
    byte[] garbage = new byte[64];
    new Random(7).nextBytes(garbage);
    try (FakeSerialDevice device =
            new FakeSerialDevice(link(), (command, far) -> far.says(garbage));
        HeadTracker tracker = open()) {
      watching.problem("answers, but not as an InterTrax2 does (wrong speed, or another device?)");
      assertThat(device.heard()).contains("c");
      assertThat(tracker.health().records()).isZero();
    }
  }

  @Test
  void aRefusedSetUpIsReported() throws IOException {
    try (FakeSerialDevice device =
            new FakeSerialDevice(link(), (command, far) -> far.says(command == 'c' ? 'o' : '?'));
        HeadTracker tracker = open()) {
      watching.problem("did not accept the command 't'");
      assertThat(device.heard()).startsWith("ct\2");
      assertThat(tracker.health().records()).isZero();
    }
  }

  @Test
  void aDeviceThatFallsSilentOrSendsGarbageIsReportedAndHeardAgain() throws IOException {
    try (FakeSerialDevice device = new FakeSerialDevice(link(), this::obeys);
        HeadTracker tracker = open()) {
      watching.more(2);
      watching.problem("no records for 0.5 s; the last orientation is kept");
      assertThat(tracker.health().stale()).isTrue();
      device.says(RECORD);
      watching.problem("records arrive again");
      long before = watching.samples();
      device.says(new byte[8 * 20]);
      watching.problem("no valid records");
      assertThat(tracker.health().bad()).isPositive();
      device.says(RECORD);
      device.says(RECORD);
      watching.until("records", () -> watching.samples() >= before + 2);
    }
  }

  /** A flood comes faster than any head tracker sends; nothing of it may pile up. */
  @Test
  void aFloodOfRecordsIsReadAndReportedOnce() throws IOException {
    byte[] flood = new byte[8 * 500];
    for (int i = 0; i < flood.length; i += RECORD.length) {
      System.arraycopy(RECORD, 0, flood, i, RECORD.length);
    }
    try (FakeSerialDevice device = new FakeSerialDevice(link(), this::obeys);
        HeadTracker tracker = open()) {
      watching.more(2);
      for (int i = 0; i < 100; i++) {
        device.says(flood);
      }
      watching.until("all", () -> tracker.health().records() >= 50_000);
      assertThat(tracker.health().bad()).isZero();
    }
  }

  private void obeys(int command, FakeSerialDevice device) throws IOException {
    switch (command) {
      case 'c' -> device.says('o');
      case 't', 'b' -> device.says(command);
      case 'd' -> {
        device.says('d');
        // The host throws away what comes while it changes its speed.
        long before = watching.samples();
        Eventually.await(
            "two records",
            () -> {
              device.says(RECORD);
              return watching.samples() >= before + 2;
            });
      }
      default -> {
        // Arguments.
      }
    }
  }

  private Path link() {
    return folder.resolve("tracker");
  }

  private HeadTracker open() throws IOException {
    return TrackerFactory.open(
        new TrackerSpec.InterTrax2(link().toString()), TrackerOptions.NONE, watching);
  }
}
