package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class CallLimitTest {
  @Test
  void callThatAllocatesTooMuchIsStopped() {
    CallLimit limit = new CallLimit(1 << 20);
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
    CallLimit limit = new CallLimit(64 << 20);
    for (int call = 0; call < 20; call++) {
      limit.begin(1000);
      limit.check(0);
      byte[] much = new byte[8 << 20];
      limit.check(0);
      assertThat(much).isNotEmpty();
    }
  }
}
