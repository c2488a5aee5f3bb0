package org.selectiverenderer.tracker.emulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 30, unit = TimeUnit.SECONDS)
class InterTrax2EmulatorTest {
  @Test
  void recordsComeOneAfterTheOtherWhenTheyAreAskedFor() throws IOException, InterruptedException {
    CountDownLatch enough = new CountDownLatch(21);
    HeadMotion motion =
        (t, into) -> {
          enough.countDown();
          into.turn(0, 0, 0);
        };
    PipedOutputStream host = new PipedOutputStream();
    try (PipedInputStream fromHost = new PipedInputStream(host);
        InterTrax2Emulator device =
            InterTrax2Emulator.start(
                fromHost,
                OutputStream.nullOutputStream(),
                new InterTrax2Emulator.Settings(100, motion))) {
      assertThat(device.streaming()).isFalse();
      host.write(new byte[] {'c', 't', 2, 'd'});
      host.flush();
      enough.await();
      assertThat(device.streaming()).isTrue();
    }
  }

  @Test
  void whatAReaderMissedIsNotSentToItAfterwards() {
    long period = 10;
    // A write that took no time, and one during which the reader stalled for 50 periods.
    assertThat(InterTrax2Emulator.next(1000, period, 1000)).isEqualTo(1010);
    long due = InterTrax2Emulator.next(1010, period, 1510);
    assertThat(due).isEqualTo(1510);
    assertThat(InterTrax2Emulator.next(due, period, 1510)).isEqualTo(1520);
  }
}
