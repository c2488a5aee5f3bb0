package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class CallLimitTest {
  private final AtomicLong nanoseconds = new AtomicLong();

  @Test
  void callThatRunsTooLongIsStopped() {
    CallLimit limit = new CallLimit(64 << 20, nanoseconds::get);
    limit.begin(1);
    nanoseconds.addAndGet(1_000_000_000);
    limit.check(0);
    nanoseconds.incrementAndGet();

    assertThatThrownBy(() -> limit.check(0))
        .isInstanceOf(ScriptStoppedError.class)
        .hasMessage("it ran for more than 1 s");
    assertThatThrownBy(limit::end).isInstanceOf(ScriptStoppedError.class);

    limit.begin(1);
    limit.check(0);
    limit.end();
  }

  @Test
  void callThatAllocatesTooMuchIsStopped() {
    CallLimit limit = new CallLimit(1 << 20, nanoseconds::get);
    limit.begin(1000);
    limit.check(0);
    byte[] much = new byte[8 << 20];

    assertThatThrownBy(() -> limit.check(0))
        .isInstanceOf(ScriptStoppedError.class)
        .hasMessageContaining("more than 1 MB of memory");
    assertThat(much).hasSize(8 << 20);
  }

  @Test
  void eachCallHasTheWholeLimit() {
    CallLimit limit = new CallLimit(64 << 20, nanoseconds::get);
    for (int call = 0; call < 20; call++) {
      limit.begin(1000);
      limit.check(0);
      byte[] much = new byte[8 << 20];
      limit.check(0);
      assertThat(much).isNotEmpty();
    }
  }
}
