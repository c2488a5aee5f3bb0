package org.selectiverenderer.formats.csv;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SpreadsheetTextTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "=HYPERLINK(\"http://example.org/\"&A1)",
        "+1+cmd|' /C calc'!A0",
        "-2+3",
        "@SUM(1)",
        "\u00a0=1",
        "\uff1d1",
        "'=1",
        "- not at all"
      })
  void textThatWouldBeCalculatedIsMarkedAndReadAgain(String answer) {
    String table = new CsvWriter().row("answer").row(answer).toString();

    assertThat(SpreadsheetText.marked(answer)).isEqualTo("'" + answer);
    assertThat(table.lines().skip(1).findFirst().orElseThrow()).matches("\"?'.*");
    assertThat(read(table)).isEqualTo(answer);
  }

  /** A spreadsheet in Greek or German separates cells by semicolons, whatever the file does. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "fine;=1+cmd            | fine;'=1+cmd",
        "fine; @SUM(1);\uff1d1+2 | fine;' @SUM(1);'\uff1d1+2",
        "=;=1                   | '=;'=1",
        "a;'=1                  | a;''=1",
        "-2;=x                  | '-2;'=x",
        "x;-2;+3.5;y            | x;-2;+3.5;y",
        "x;-2+3                 | x;'-2+3",
      })
  void aCellThatBeginsWithinTheTextIsMarkedToo(String answer, String marked) {
    assertThat(SpreadsheetText.marked(answer)).isEqualTo(marked);
    assertThat(SpreadsheetText.plain(marked)).isEqualTo(answer);
    assertThat(read(new CsvWriter().row("answer").row(answer).toString())).isEqualTo(answer);
  }

  @Test
  void aCellThatBeginsOnAnotherLineIsMarkedToo() {
    assertThat(SpreadsheetText.marked("a\n=1\t=2\r\n")).isEqualTo("a\n'=1\t'=2\r\n");
    assertThat(SpreadsheetText.marked("\n=1")).isEqualTo("\n'=1");
    assertThat(SpreadsheetText.plain("\n'=1")).isEqualTo("\n=1");
  }

  @ParameterizedTest
  @ValueSource(strings = {"-1", "-.35**", "+2.5e-3", "-Infinity", "'quoted'", "a=b", "-", ""})
  void numbersAndOtherTextStay(String cell) {
    assertThat(SpreadsheetText.marked(cell)).isEqualTo(cell);
    assertThat(SpreadsheetText.plain(cell)).isEqualTo(cell);
  }

  @Test
  void tablesForProgramsHaveNoMarks() {
    assertThat(CsvWriter.line("=1", -2, "+x")).isEqualTo("=1,-2,+x\n");
  }

  private static String read(String table) {
    return CsvTable.parse("a.csv", table, (at, fault) -> {})
        .orElseThrow()
        .rows()
        .get(0)
        .cell("answer");
  }
}
