package org.selectiverenderer.study.headlog;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.base.problem.Problem;

/** A disk that fails or lags behind costs the log, never the session. */
@Timeout(value = 30, unit = TimeUnit.SECONDS)
class HeadLogWriterTest {
  private final LinkedBlockingQueue<Problem> problems = new LinkedBlockingQueue<>();

  private static HeadSample sample(double t) {
    return new HeadSample(
        t,
        0,
        0,
        0,
        0,
        0,
        0,
        false,
        "A",
        1,
        0,
        List.of(),
        List.of(),
        4,
        HeadSample.Moment.UNTOLD,
        null);
  }

  private abstract static class Disk implements HeadLogWriter.Lines {
    final StringBuffer taken = new StringBuffer();

    @Override
    public void keep() throws IOException {
      // Nothing to do.
    }

    @Override
    public void close() {
      // Nothing to do.
    }
  }

  @Test
  void whatASlowDiskCannotTakeIsLeftOutAndCounted() throws IOException, InterruptedException {
    CountDownLatch writing = new CountDownLatch(1);
    CountDownLatch spinning = new CountDownLatch(1);
    Disk disk =
        new Disk() {
          @Override
          public void write(String text) {
            taken.append(text);
            writing.countDown();
            try {
              spinning.await();
            } catch (InterruptedException e) {
              throw new IllegalStateException(e);
            }
          }
        };
    HeadLogWriter writer = HeadLogWriter.start(Path.of("p01.csv"), disk, false, 10, problems::add);
    writer.add(sample(0));
    writing.await();
    for (int i = 1; i <= 15; i++) {
      writer.add(sample(i)); // Returns at once: the disk stands still.
    }
    assertThat(writer.lost()).isEqualTo(5);
    spinning.countDown();
    writer.close();
    assertThat(disk.taken.toString().lines()).hasSize(11);
    assertThat(problems).hasSize(1);
    assertThat(problems.take().toString())
        .contains("p01.csv", "5 frames are missing from the head log");
  }

  @Test
  void aDiskThatIsSlowToKeepDoesNotHoldBackWhatIsWritten() throws Exception {
    CountDownLatch keeping = new CountDownLatch(1);
    CountDownLatch spinning = new CountDownLatch(1);
    LinkedBlockingQueue<String> written = new LinkedBlockingQueue<>();
    Disk disk =
        new Disk() {
          @Override
          public void write(String text) {
            written.add(text);
          }

          @Override
          public void keep() {
            keeping.countDown();
            try {
              spinning.await();
            } catch (InterruptedException e) {
              throw new IllegalStateException(e);
            }
          }
        };
    HeadLogWriter writer = HeadLogWriter.start(Path.of("p01.csv"), disk, false, 10, problems::add);
    keeping.await();
    writer.add(sample(7)); // Killed now, the program would have written it.
    assertThat(written.take()).startsWith("7.");
    spinning.countDown();
    writer.close();
    assertThat(problems).isEmpty();
  }

  @Test
  void aDiskThatFailsToKeepEndsTheLogWithAMessage() throws IOException, InterruptedException {
    Disk disk =
        new Disk() {
          @Override
          public void write(String text) {
            taken.append(text);
          }

          @Override
          public void keep() throws IOException {
            throw new IOException("the disk is gone");
          }
        };
    HeadLogWriter writer = HeadLogWriter.start(Path.of("p01.csv"), disk, false, 10, problems::add);
    assertThat(problems.take().toString()).contains("the head log ends here", "the disk is gone");
    writer.close();
    assertThat(problems).isEmpty();
  }

  @Test
  void anErrorOfOursEndsTheLogWithAMessage() throws IOException, InterruptedException {
    Disk disk =
        new Disk() {
          @Override
          public void write(String text) {
            throw new IllegalStateException("of ours");
          }
        };
    HeadLogWriter writer = HeadLogWriter.start(Path.of("p01.csv"), disk, false, 10, problems::add);
    writer.add(sample(0));
    assertThat(problems.take().toString()).contains("the head log ends here", "of ours");
    writer.add(sample(1));
    writer.close();
    assertThat(problems).isEmpty();
  }

  @Test
  void theUsualDiskKeepsUpWithTheFastestFrames() throws IOException {
    Disk disk =
        new Disk() {
          @Override
          public void write(String text) {
            taken.append(text);
          }
        };
    HeadLogWriter writer =
        HeadLogWriter.start(
            Path.of("p01.csv"), disk, false, HeadLogWriter.MOST_WAITING, problems::add);
    for (int i = 0; i < 20_000; i++) {
      writer.add(sample(i * 0.001));
    }
    writer.close();
    assertThat(writer.lost()).isZero();
    assertThat(disk.taken.toString().lines()).hasSize(20_000);
  }
}
