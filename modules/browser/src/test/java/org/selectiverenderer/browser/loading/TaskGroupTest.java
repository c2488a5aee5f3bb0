package org.selectiverenderer.browser.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class TaskGroupTest {
  private final ExecutorService oneThread = Executors.newSingleThreadExecutor();

  @AfterEach
  void close() {
    oneThread.shutdownNow();
  }

  @Test
  void tasksOfTasksAreWaitedFor() {
    TaskGroup tasks = new TaskGroup(oneThread);
    AtomicInteger done = new AtomicInteger();
    for (int i = 0; i < 10; i++) {
      tasks.start(
          () -> {
            done.incrementAndGet();
            tasks.start(() -> tasks.start(done::incrementAndGet));
          });
    }
    TaskGroup.await(tasks.end());
    assertThat(done).hasValue(20);
  }

  @Test
  void aGroupWithoutTasksEndsAtOnce() {
    assertThat(new TaskGroup(oneThread).end()).isCompleted();
  }

  @Test
  void whatATaskThrowsReachesWhoWaitsAfterTheOthersAreDone() {
    TaskGroup tasks = new TaskGroup(oneThread);
    AtomicInteger done = new AtomicInteger();
    tasks.start(
        () -> {
          throw new OutOfMemoryError("made up");
        });
    tasks.start(done::incrementAndGet);
    assertThatThrownBy(() -> TaskGroup.await(tasks.end()))
        .isInstanceOf(OutOfMemoryError.class)
        .hasMessage("made up");
    assertThat(done).hasValue(1);
  }

  @Test
  void aClosedExecutorIsAFailureAndNoHang() {
    oneThread.shutdown();
    TaskGroup tasks = new TaskGroup(oneThread);
    tasks.start(() -> {});
    assertThatThrownBy(() -> TaskGroup.await(tasks.end())).isInstanceOf(RuntimeException.class);
  }
}
