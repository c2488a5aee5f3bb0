package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** The process that is measured. */
class ChildProcessRunTest {
  /** In the place of the program: it does not end by itself. */
  static final class Endless {
    private Endless() {}

    public static void main(String[] arguments) throws InterruptedException {
      new CountDownLatch(1).await(10, TimeUnit.MINUTES);
    }
  }

  @Test
  void endsWithTheMeasurementThatIsInterrupted() throws Exception {
    List<ProcessHandle> before = ProcessHandle.current().children().toList();
    ChildProcessRun run = new ChildProcessRun(Endless.class.getName(), 1);

    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> run.once(Path.of("any.x3d"), List.of()))
        .isInstanceOf(InterruptedException.class);

    List<ProcessHandle> left =
        ProcessHandle.current().children().filter(one -> !before.contains(one)).toList();
    for (ProcessHandle child : left) {
      assertThat(child.onExit().get(60, TimeUnit.SECONDS).isAlive()).isFalse();
    }
  }
}
