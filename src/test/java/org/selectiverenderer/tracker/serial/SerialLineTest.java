package org.selectiverenderer.tracker.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(value = 30, unit = TimeUnit.SECONDS)
class SerialLineTest {
  @TempDir Path folder;

  @Test
  void whatWasSentBeforeItWasOpenedIsThrownAway() throws IOException {
    Path link = folder.resolve("tracker");
    try (FarEnd device = new FarEnd(link, (command, far) -> far.says(command + 1))) {
      device.says(new byte[20_000]);
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
}
