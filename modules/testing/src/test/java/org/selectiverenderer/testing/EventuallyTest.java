package org.selectiverenderer.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class EventuallyTest {
  @Test
  void aConditionIsEvaluatedUntilItHolds() {
    AtomicInteger evaluations = new AtomicInteger();
    Eventually.await("five evaluations", () -> evaluations.incrementAndGet() == 5);
    assertThat(evaluations).hasValue(5);
  }

  @Test
  void aConditionThatNeverHoldsEndsTheWait() {
    assertThat(Eventually.within(1, TimeUnit.MILLISECONDS, () -> false)).isFalse();
  }

  @Test
  void aConditionThatFailsEndsTheWait() {
    assertThatThrownBy(
            () ->
                Eventually.await(
                    "a file",
                    () -> {
                      throw new IOException("no disk");
                    }))
        .isInstanceOf(AssertionError.class)
        .hasRootCauseMessage("no disk");
  }

  @Test
  void anInterruptEndsTheWaitAndIsKept() {
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> Eventually.await("nothing", () -> false)).hasMessage("interrupted");
    assertThat(Thread.interrupted()).isTrue();
  }
}
