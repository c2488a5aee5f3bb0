package org.selectiverenderer.csv;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;

class FixedDecimalsTest {
  @Test
  void allDecimalsAreWrittenAndNoExponents() {
    assertThat(FixedDecimals.of(12.5, 3)).isEqualTo("12.500");
    assertThat(FixedDecimals.of(1e-7, 6)).isEqualTo("0.000000");
    assertThat(FixedDecimals.of(1.5e-4, 6)).isEqualTo("0.000150");
    assertThat(FixedDecimals.of(-1e10, 2)).isEqualTo("-10000000000.00");
    assertThat(FixedDecimals.of(2.0 / 3, 6)).isEqualTo("0.666667");
  }

  @Test
  void whatRoundsToZeroHasNoSign() {
    assertThat(FixedDecimals.of(-0.0, 2)).isEqualTo("0.00");
    assertThat(FixedDecimals.of(-1e-9, 6)).isEqualTo("0.000000");
  }

  @Test
  void aCommaOfTheLocaleIsNotUsed() {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.GERMANY);
    try {
      assertThat(FixedDecimals.of(1.25, 2)).isEqualTo("1.25");
    } finally {
      Locale.setDefault(before);
    }
  }
}
