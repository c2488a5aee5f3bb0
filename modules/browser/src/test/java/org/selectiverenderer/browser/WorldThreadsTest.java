package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class WorldThreadsTest {

  @Test
  void noWriteIsLostAndThoseOfAThreadKeepTheirOrder() throws InterruptedException {
    int threads = 6;
    int writes = 5000;
    try (WorldFixture fixture = new WorldFixture("<Group/>")) {
      List<List<Integer>> seen = new ArrayList<>();
      AtomicInteger atOnce = new AtomicInteger();
      AtomicInteger most = new AtomicInteger();
      CountDownLatch done = new CountDownLatch(threads);
      for (int i = 0; i < threads; i++) {
        List<Integer> mine = new ArrayList<>();
        seen.add(mine);
        Thread thread =
            new Thread(
                () -> {
                  for (int n = 0; n < writes; n++) {
                    int number = n;
                    fixture.world.execute(
                        () -> {
                          most.accumulateAndGet(atOnce.incrementAndGet(), Math::max);
                          mine.add(number);
                          atOnce.decrementAndGet();
                        });
                  }
                  done.countDown();
                });
        thread.setDaemon(true);
        thread.start();
      }
      double time = 0;
      while (done.getCount() > 0) {
        fixture.step(time++);
      }
      fixture.step(time);
      for (List<Integer> mine : seen) {
        assertThat(mine).hasSize(writes).isSorted();
      }
      assertThat(most.get()).isEqualTo(1);
    }
  }

  @Test
  void onTheSteppingThreadATaskRunsAtOnce() {
    try (WorldFixture fixture = new WorldFixture("<Group/>")) {
      fixture.world.onStep(() -> fixture.world.execute(() -> fixture.log.add("in step")));
      fixture.step(0);
      assertThat(fixture.log).containsExactly("in step");
    }
  }

  @Test
  void betweenStepsATaskRunsAtOnceAndWhatIsPostedWaits() {
    try (WorldFixture fixture = new WorldFixture("<Group/>")) {
      fixture.world.execute(() -> fixture.log.add("a"));
      assertThat(fixture.log).containsExactly("a");
      fixture.world.post(() -> fixture.log.add("b"));
      fixture.world.execute(() -> fixture.log.add("c"));
      assertThat(fixture.log).containsExactly("a", "c");
      fixture.step(0);
      assertThat(fixture.log).containsExactly("a", "c", "b");
    }
  }

  @Test
  void aTaskThatTheStepItselfWaitsForIsLeftToTheNextStep() throws InterruptedException {
    try (WorldFixture fixture = new WorldFixture("<Group/>")) {
      CountDownLatch handedOver = new CountDownLatch(1);
      fixture.world.post(
          () -> {
            Thread other =
                new Thread(
                    () -> {
                      fixture.world.execute(() -> fixture.log.add("other"));
                      handedOver.countDown();
                    });
            other.setDaemon(true);
            other.start();
            await(handedOver);
          });
      fixture.step(0);
      assertThat(fixture.log).isEmpty();
      fixture.step(1);
      assertThat(fixture.log).containsExactly("other");
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
