package org.selectiverenderer.base.decimal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DecimalFormatterTest {
  @ParameterizedTest
  @CsvSource({
    "12.5, 3, 12.500",
    "1e-7, 6, 0.000000",
    "1.5e-4, 6, 0.000150",
    "-1e10, 2, -10000000000.00",
    "1e20, 1, 100000000000000000000.0",
    "0.6666666666666666, 6, 0.666667",
    "7.5, 0, 8",
    "-0.0, 2, 0.00",
    "-1e-9, 6, 0.000000"
  })
  void fixedWritesAllDecimalsAndNoExponents(double value, int decimals, String text) {
    assertThat(DecimalFormatter.fixed(value, decimals)).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource({
    "0, 4, 0",
    "-0.0, 4, 0",
    "-0.00001, 4, 0",
    "0.5, 4, 0.5",
    "-1.5, 2, -1.5",
    "0.06, 1, 0.1",
    "12.3456, 4, 12.3456",
    "100, 0, 100",
    "-100, 4, -100",
    "1e20, 4, 1E+20"
  })
  void roundedWritesNoZerosThatSayNothing(double value, int decimals, String text) {
    assertThat(DecimalFormatter.rounded(value, decimals)).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource({"0.125, 0.12", "0.375, 0.38", "-0.125, -0.12", "1.005, 1.0", "1.015, 1.02"})
  void tiesOfTheDecimalTextGoToTheEvenDigit(double value, String text) {
    assertThat(DecimalFormatter.rounded(value, 2)).isEqualTo(text.replaceFirst("\\.0$", ""));
  }

  @Test
  void theFastWayRoundsAsTheExactOne() {
    Random random = new Random(1);
    for (int i = 0; i < 200_000; i++) {
      double value = random.nextInt(2_000_000) / 1e6 * Math.pow(10, random.nextInt(9) - 4);
      int decimals = random.nextInt(10);
      BigDecimal exact = BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_EVEN);
      assertThat(DecimalFormatter.fixed(value, decimals)).isEqualTo(exact.toPlainString());
    }
  }

  @Test
  void shortestReadsAsTheSameNumber() {
    assertThat(DecimalFormatter.shortest(0.1f)).isEqualTo("0.1");
    assertThat(DecimalFormatter.shortest(1e-30f)).isEqualTo("1E-30");
    assertThat(DecimalFormatter.shortest(16777216f)).isEqualTo("16777216");
    assertThat(DecimalFormatter.shortest(-0f)).isEqualTo("0");
    assertThat(DecimalFormatter.shortest(100.0)).isEqualTo("100");
    assertThat(DecimalFormatter.shortest(0.1 + 0.2)).isEqualTo("0.30000000000000004");
  }

  @Test
  void whatIsNoNumberIsRefused() {
    assertThatThrownBy(() -> DecimalFormatter.fixed(Double.NaN, 2))
        .isInstanceOf(NumberFormatException.class);
    assertThatThrownBy(() -> DecimalFormatter.rounded(Double.POSITIVE_INFINITY, 2))
        .isInstanceOf(NumberFormatException.class);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "999, 999", "1000, '1,000'", "-999, -999", "-1234567, '-1,234,567'"})
  void digitsAreGroupedForPeople(long value, String text) {
    assertThat(DecimalFormatter.grouped(value)).isEqualTo(text);
  }

  @Test
  void theLocaleDoesNotMatter() {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag("ar-EG"));
    try {
      assertThat(DecimalFormatter.fixed(1234.25, 2)).isEqualTo("1234.25");
      assertThat(DecimalFormatter.grouped(1234)).isEqualTo("1,234");
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void aNumberCanStayANumber() {
    assertThat(DecimalRounding.to(1, 0.25)).isEqualTo(0.3);
    assertThat(DecimalRounding.to(0, -0.5)).isEqualTo(0);
    assertThat(DecimalRounding.to(6, 1.0000004)).isEqualTo(1);
  }
}
