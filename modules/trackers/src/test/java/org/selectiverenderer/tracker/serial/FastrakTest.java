package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.Orientation;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.RecordingTrackerListener;
import org.selectiverenderer.tracker.TrackerOptions;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;

class FastrakTest {
  private static final String RECORD = "01   12.50 -45.25   3.00\r\n";

  @TempDir Path folder;
  private final RecordingTrackerListener watching = new RecordingTrackerListener();

  @Test
  void isAskedForAnglesOfStationOneAndReadThem() throws IOException {
    try (FakeSerialDevice device = sending(RECORD.repeat(3));
        HeadTracker tracker = open()) {
      watching.more(3);
      assertThat(device.heard()).isEqualTo("cFuO1,2,4,1\r\nC");
      PoseSample pose = new PoseSample();
      assertThat(tracker.read(pose)).isTrue();
      assertThat(pose.orientation()).isEqualTo(new Orientation(12.5, -45.25, 3));
    }
  }

  @Test
  void thePlaceIsTurnedFromItsAxesToThoseOfTheViewer() throws IOException {
    // 40 cm to the front, 12.5 cm to the right, 30 cm down.
    String whole = "01   40.00  12.50  30.00  12.50 -45.25   3.00\r\n";
    try (FakeSerialDevice device = sending(whole.repeat(2));
        HeadTracker tracker = open()) {
      watching.more(2);
      assertThat(device.heard()).endsWith("C");
      assertThat(watching.places).containsOnly("0.125 -0.3 -0.4");
      assertThat(watching.orientations).containsOnly(new Orientation(12.5, -45.25, 3));
      assertThat(tracker.placed()).isTrue();
    }
  }

  @Test
  void whatIsNotExactlyARecordIsBad() throws IOException {
    try (FakeSerialDevice device =
            sending(
                RECORD
                    + "01   12.50 -45.25   3.0\r\n" // short
                    + "01   12.50 -45.25   3.000\r\n" // long
                    + "02   12.50 -45.25   3.00\r\n" // another station
                    + "21   12.50 -45.25   3.00\r\n" // status record
                    + "01   12.50 -4x.25   3.00\r\n"
                    + "01   12.50 - 5.25   3.00\r\n"
                    + "01   12.50    nan   3.00\r\n"
                    + "01  999.50 -45.25   3.00\r\n" // no angle
                    + RECORD);
        HeadTracker tracker = open()) {
      watching.until("two records", () -> watching.samples() == 2);
      assertThat(device.heard()).endsWith("C");
      assertThat(tracker.health().bad()).isEqualTo(8);
    }
  }

  @Test
  void aWrongSpeedIsNamed() throws IOException {
    byte[] garbage = {(byte) 0xf8, 0x00, (byte) 0x80, 0x78, '\n', (byte) 0xff};
    try (FakeSerialDevice device =
            new FakeSerialDevice(
                folder.resolve("tracker"),
                (command, far) -> {
                  if (command == 'C') {
                    far.says(garbage);
                  }
                });
        HeadTracker tracker = open()) {
      watching.problem("not as a Fastrak does at 9600 bits per second (another speed?");
      assertThat(device.heard()).contains("C");
      assertThat(tracker.health().records()).isZero();
    }
  }

  @Test
  void silenceIsNamed() throws IOException {
    try (FakeSerialDevice device =
            new FakeSerialDevice(folder.resolve("tracker"), (command, far) -> {});
        HeadTracker tracker = open()) {
      watching.problem("no Fastrak answers (is it powered, and set to 9600 bits per second?)");
      assertThat(device.heard()).contains("C");
      assertThat(tracker.health().records()).isZero();
    }
  }

  private FakeSerialDevice sending(String text) throws IOException {
    return new FakeSerialDevice(
        folder.resolve("tracker"),
        (command, far) -> {
          if (command == 'C') {
            far.says(text.getBytes(StandardCharsets.US_ASCII));
          }
        });
  }

  private HeadTracker open() throws IOException {
    return TrackerFactory.open(
        new TrackerSpec.Fastrak(folder.resolve("tracker").toString(), 9600),
        TrackerOptions.NONE,
        watching);
  }
}
