package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ScriptTimeBudgetTest {
  private final ScriptTimeBudget together = new ScriptTimeBudget();

  @Test
  void callsOfOneTimeStampAreCountedTogether() {
    for (int call = 0; call < 10; call++) {
      assertThat(together.add(5, 0.9)).isFalse();
    }
    assertThat(together.over(5)).isFalse();

    assertThat(together.add(5, 1.1)).isTrue();

    assertThat(together.over(5)).isTrue();
    assertThat(together.add(5, 1)).isFalse(); // It is told once.
  }

  @Test
  void nextTimeStampBeginsAnew() {
    together.add(5, 11);

    assertThat(together.over(6)).isFalse();
    assertThat(together.add(6, 9)).isFalse();
  }
}
