package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ScriptTimeBudgetTest {
  private final ScriptTimeBudget budget = new ScriptTimeBudget();
  private final ScriptTimeBudget.Used calling = budget.calling();

  @Test
  void callsOfOneTimeStampAreCountedTogether() {
    for (int call = 0; call < 10; call++) {
      assertThat(calling.add(5, 0.9)).isFalse();
    }
    assertThat(calling.over(5)).isFalse();

    assertThat(calling.add(5, 1.1)).isTrue();

    assertThat(calling.over(5)).isTrue();
    assertThat(calling.add(5, 1)).isFalse(); // It is told once.
  }

  @Test
  void timeThatPassesInTheSceneIsRegained() {
    calling.add(5, 13);

    assertThat(calling.over(5.5)).isTrue();
    assertThat(calling.over(5.8)).isFalse();
    assertThat(calling.add(9, 10)).isFalse(); // All is regained, but no more than that.
    assertThat(calling.add(9, 1)).isTrue();
  }

  @Test
  void framesThatEachTakeLongUseTheBudgetUp() {
    int frames = 0;
    while (!calling.add(5 + frames / 60.0, 0.9)) {
      frames++;
    }

    assertThat(frames).isBetween(11, 13);
  }

  @Test
  void timeThatGoesBackRegainsNothing() {
    calling.add(5, 11);

    assertThat(calling.over(4)).isTrue();
  }

  @Test
  void startsHaveABudgetOfTheirOwn() {
    assertThat(budget.starting().add(5, 9)).isFalse();
    assertThat(budget.starting().add(5, 2)).isTrue();

    assertThat(calling.over(5)).isFalse();
  }
}
