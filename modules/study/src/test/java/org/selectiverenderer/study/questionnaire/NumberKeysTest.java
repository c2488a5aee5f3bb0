package org.selectiverenderer.study.questionnaire;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Numbers of scales, typed digit by digit. */
class NumberKeysTest {
  private static NumberKeys scale(int from, int to) {
    return NumberKeys.of(AnswerField.Choice.numbers(from, to, "", "", List.of())).orElseThrow();
  }

  private static NumberKeys typed(NumberKeys keys, String typed) {
    NumberKeys all = keys;
    for (char each : typed.toCharArray()) {
      all = all.and(each);
    }
    return all;
  }

  @Test
  void aDigitWaitsOnlyWhereAnotherCanFollow() {
    NumberKeys one = scale(0, 10).and('1');
    assertThat(one.waits()).isTrue();
    assertThat(one.value()).hasValue("1");
    assertThat(one.and('0').waits()).isFalse();
    assertThat(one.and('0').value()).hasValue("10");
    assertThat(scale(0, 10).and('7').waits()).isFalse();
    assertThat(scale(1, 5).and('1').waits()).isFalse();
    assertThat(scale(0, 10).mayWait()).isTrue();
    assertThat(scale(0, 9).mayWait()).isFalse();
    assertThat(scale(0, 10).waits()).as("before the first key").isFalse();
  }

  @Test
  void aDigitThatCannotFollowBeginsAnew() {
    assertThat(typed(scale(0, 10), "15").value()).hasValue("5");
    assertThat(typed(scale(10, 20), "5").typed()).isEmpty();
    assertThat(typed(scale(10, 20), "1").value()).isEmpty();
    assertThat(typed(scale(10, 20), "13").value()).hasValue("13");
  }

  @Test
  void numbersBelowZeroBeginWithTheirSign() {
    assertThat(scale(-10, 0).and('-').waits()).isTrue();
    assertThat(scale(-10, 0).and('-').value()).isEmpty();
    assertThat(typed(scale(-10, 0), "-1").waits()).isTrue();
    assertThat(typed(scale(-10, 0), "-10").value()).hasValue("-10");
    assertThat(typed(scale(-3, 3), "-2").waits()).isFalse();
    assertThat(scale(0, 10).takes('-')).isFalse();
  }

  @Test
  void optionsThatAreChosenByTheirPlacesAreNotTyped() {
    List<ChoiceOption> places =
        List.of(ChoiceOption.of("10", "10", "1"), ChoiceOption.of("20", "20", "2"));
    assertThat(NumberKeys.of(AnswerField.Choice.of(places))).isEmpty();
  }
}
