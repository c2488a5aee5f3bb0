package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.FileInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.Eventually;

@Timeout(value = 30, unit = TimeUnit.SECONDS)
class SerialLineTest {
  /** Less than a terminal holds. */
  private static final int STALE = 2000;

  @TempDir Path folder;

  @Test
  void whatWasSentBeforeItWasOpenedIsThrownAway() throws IOException {
    Path link = folder.resolve("tracker");
    try (FakeSerialDevice device =
        new FakeSerialDevice(link, (command, far) -> far.says(command + 1))) {
      device.says(new byte[STALE]);
      // What does not read sees how much has come so far.
      try (FileInputStream arrived = new FileInputStream(link.toFile())) {
        Eventually.await("the stale bytes", () -> arrived.available() >= STALE);
      }
      SerialLine line = SerialLine.open(link.toString(), 38400);
      byte[] bytes = new byte[100];
      line.write((byte) 'a');
      int count = line.read(bytes);
      while (count == 0) {
        count = line.read(bytes);
      }
      assertThat(count).isEqualTo(1);
      assertThat(bytes[0]).isEqualTo((byte) 'b');
      line.close();
    }
  }

  @Test
  void aReadOfASilentPortEndsAndAReadDoesNotWaitForMoreThanHasArrived() throws IOException {
    Path link = folder.resolve("tracker");
    try (FakeSerialDevice device = new FakeSerialDevice(link, (command, far) -> {})) {
      SerialLine line = SerialLine.open(link.toString(), 38400);
      byte[] bytes = new byte[100];
      assertThat(line.read(bytes)).isZero();
      device.says(1, 2, 3);
      ByteArrayOutputStream heard = new ByteArrayOutputStream();
      while (heard.size() < 3) {
        heard.write(bytes, 0, line.read(bytes));
      }
      assertThat(heard.toByteArray()).containsExactly(1, 2, 3);
      line.close();
    }
  }
}
