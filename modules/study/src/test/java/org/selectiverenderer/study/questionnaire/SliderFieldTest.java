package org.selectiverenderer.study.questionnaire;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SliderFieldTest {
  private static SliderField tenths() {
    return new SliderField(
        BigDecimal.valueOf(-1),
        BigDecimal.valueOf(1),
        BigDecimal.valueOf(0.1),
        "near",
        "far",
        true,
        true,
        OptionalInt.empty());
  }

  @Test
  void valuesAreExactWhateverTheStep() {
    SliderField slider = tenths();
    assertThat(slider.last()).isEqualTo(20);
    assertThat(slider.values()).hasSize(21).startsWith("-1", "-0.9").endsWith("0.9", "1");
    assertThat(slider.values()).contains("0", "0.3").doesNotContain("-0", "0.0");
    for (int position = 0; position <= slider.last(); position++) {
      assertThat(slider.position(slider.value(position))).hasValue(position);
    }
    assertThat(slider.nearest(0.26)).isEqualTo("0.3");
    assertThat(slider.nearest(-7)).isEqualTo("-1");
    assertThat(slider.nearest(7)).isEqualTo("1");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "0.05", "1.1", "-1.1", "1e0", "near", "0.1|0.2", "99999999999999"})
  void whatIsNoValueIsNoAnswer(String text) {
    assertThat(tenths().position(text)).isEmpty();
    assertThat(tenths().typed(text)).isEmpty();
  }

  @Test
  void aTypedNumberMayHaveADecimalComma() {
    assertThat(tenths().typed(" 0,3 ")).hasValue("0.3");
    assertThat(tenths().typed("+1.0")).hasValue("1");
    assertThat(tenths().allowed()).isEqualTo("-1 to 1 in steps of 0.1");
    assertThat(SliderField.numbers(0, 100, "", "").allowed()).isEqualTo("0 to 100");
  }

  @Test
  void theFirstKeyPutsAHiddenThumbIntoTheMiddle() {
    SliderField slider = SliderField.numbers(0, 100, "", "");
    assertThat(slider.moved(OptionalInt.empty(), -1)).isEqualTo(50);
    assertThat(slider.moved(OptionalInt.of(0), -1)).isZero();
    assertThat(slider.moved(OptionalInt.of(99), slider.page())).isEqualTo(100);
    assertThat(slider.page()).isEqualTo(10);
  }

  @Test
  void marksAreFewEnoughToBeSeen() {
    assertThat(SliderField.numbers(0, 100, "", "").marked()).hasSize(21).contains(0, 5, 100);
    assertThat(SliderField.numbers(0, 100, "", "").labelled()).hasSize(11).contains(0, 10, 100);
    assertThat(SliderField.numbers(0, 97, "", "").marked()).containsExactly(0, 97);
    assertThat(SliderField.numbers(1, 12, "", "").labelled()).containsExactly(0, 11);
  }

  @Test
  void simulatedAnswersAreValid() {
    SliderField slider = tenths();
    Random random = new Random(1);
    for (int i = 0; i < 100; i++) {
      String value = slider.simulated(random);
      assertThat(slider.typed(value)).hasValue(value);
    }
  }
}
