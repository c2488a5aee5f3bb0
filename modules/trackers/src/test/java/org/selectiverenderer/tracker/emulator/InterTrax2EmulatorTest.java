package org.selectiverenderer.tracker.emulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 30, unit = TimeUnit.SECONDS)
class InterTrax2EmulatorTest {
  /** A cable whose reader stops for half a second after the first record. */
  private static final class Stalling extends OutputStream {
    private int records;

    @Override
    public void write(int b) {
      // Replies to commands.
    }

    @Override
    public void write(byte[] bytes, int from, int count) {
      if (count == InterTrax2Emulator.InterTraxRecordEncoder.LENGTH && ++records == 1) {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(500);
        while (System.nanoTime() < end) {
          LockSupport.parkNanos(end - System.nanoTime());
        }
      }
    }
  }

  @Test
  void whatAReaderMissedIsNotSentToItAfterwards() throws IOException, InterruptedException {
    List<Double> told = new CopyOnWriteArrayList<>();
    CountDownLatch enough = new CountDownLatch(21);
    HeadMotion motion =
        (t, into) -> {
          told.add(t);
          enough.countDown();
          into.turn(0, 0, 0);
        };
    PipedOutputStream host = new PipedOutputStream();
    try (PipedInputStream fromHost = new PipedInputStream(host);
        InterTrax2Emulator device =
            InterTrax2Emulator.start(
                fromHost, new Stalling(), new InterTrax2Emulator.Settings(100, motion))) {
      host.write(new byte[] {'c', 't', 2, 'd'});
      host.flush();
      enough.await();
      assertThat(device.streaming()).isTrue();
      // Twenty more records of 10 ms each; those of the stalled half second would come at once.
      assertThat(told.get(20) - told.get(0)).isGreaterThan(0.6);
    }
  }
}
