package org.selectiverenderer.formats.csv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CsvTableTest {
  private final List<String> faults = new ArrayList<>();
  private final CsvErrorHandler hears = (at, message) -> faults.add(at + ": " + message);

  private CsvTable table(String text) {
    return CsvTable.parse("a.csv", text, hears).orElseThrow();
  }

  private OptionalDouble number(CsvTable table, int row, String column) {
    return CsvNumberParser.number(table.rows().get(row), column, hears);
  }

  @ParameterizedTest
  @ValueSource(chars = {',', ';', '\t'})
  void theSeparatorIsThatOfTheHeader(char separator) {
    String mark = separator == ';' ? "\uFEFF" : "";
    String text = mark + "Object|Schema|\"a,b;c\td\"\r\n\r\n\"x|\"\"y\"\"\"|Desk|1\r\n";
    CsvTable table = table(text.replace('|', separator));
    assertThat(table.rows()).hasSize(1);
    assertThat(table.rows().get(0).cell("object")).isEqualTo("x" + separator + "\"y\"");
    assertThat(table.rows().get(0).cell("A,B;C\tD")).isEqualTo("1");
    assertThat(table.rows().get(0).location("schema")).hasToString("a.csv:3:11");
    assertThat(faults).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      delimiter = '|',
      value = {
        "a;b;c,d|SEMICOLON",
        "a,b,c;d|COMMA",
        "a,b;c|COMMA",
        "alone|COMMA",
        "`\n\n\"a,b,c\";d\n1,2,3,4,5`|SEMICOLON",
        "`\"a\nb,c,d\";e\n`|SEMICOLON",
        "`a\tb,c\td`|TAB",
      })
  void mostOutsideQuotesCounts(String text, CsvDelimiter separator) {
    assertThat(CsvDelimiter.of(text)).isEqualTo(separator);
  }

  @Test
  void spaceRoundQuotesDoesNotCount() {
    assertThat(table("a, b\n1, \"x, y\" \n").rows().get(0).cell("b")).isEqualTo("x, y");
  }

  @Test
  void aTableOfSemicolonsMayHaveDecimalCommas() {
    CsvTable table = table("t;x\n0;1,5\n1;-2,25e1\n2;3\n");
    assertThat(number(table, 0, "x")).hasValue(1.5);
    assertThat(number(table, 1, "x")).hasValue(-22.5);
    assertThat(number(table, 2, "x")).hasValue(3);
    assertThat(faults).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"t,x\n0,\"4,5\"\n", "t\tx\n0\t4,5\n", "t,x\n0,\"4,50e0\"\n"})
  void elsewhereADecimalCommaIsOneToo(String text) {
    assertThat(number(table(text), 0, "x")).hasValue(4.5);
    assertThat(table(text).rows().get(0).decimal("x")).startsWith("4.5");
    assertThat(faults).isEmpty();
  }

  @Test
  void elsewhereTooATableHasOneDecimalSign() {
    CsvTable table = table("t,x\n0.5,\"4,5\"\n");
    assertThat(number(table, 0, "t")).hasValue(0.5);
    assertThat(number(table, 0, "x")).isEmpty();
    assertThat(faults)
        .containsExactly(
            "a.csv:2:5: '4,5' has a decimal comma where '0.5' in line 2 has a decimal point");
  }

  @Test
  void aTableOfSemicolonsMayHaveDecimalPoints() {
    CsvTable table = table("t;x\n0;1.5\n");
    assertThat(number(table, 0, "x")).hasValue(1.5);
    assertThat(faults).isEmpty();
  }

  /** A point may separate thousands where a comma is the decimal sign, and the other way round. */
  @Test
  void bothDecimalSignsInOneTableAreAFault() {
    CsvTable table = table("t;x\n0,5;1.234\n1;2.5\n");
    assertThat(number(table, 0, "t")).hasValue(0.5);
    assertThat(number(table, 0, "x")).isEmpty();
    assertThat(faults)
        .containsExactly(
            "a.csv:2:5: '1.234' has a decimal point where '0,5' in line 2 has a decimal comma");
  }

  @ParameterizedTest
  @ValueSource(strings = {"t,x\n0,\"1,234\"\n", "t\tx\n0\t1,234\n"})
  void elsewhereACommaBeforeThreeDigitsIsRefusedWithAdvice(String text) {
    assertThat(number(table(text), 0, "x")).isEmpty();
    assertThat(faults)
        .containsExactly(
            "a.csv:2:3: '1,234' is not a number (write it with a decimal point, not a comma)");
  }

  @ParameterizedTest
  @ValueSource(strings = {"1,234,5", "1.234,5", "1 234", ""})
  void whatIsNoNumberWithADecimalCommaIsNone(String cell) {
    assertThat(number(table("t;x\n0;" + cell + "\n"), 0, "x")).isEmpty();
    assertThat(faults).hasSize(1);
  }

  @Test
  void aRowThatDoesNotFitTheHeaderIsLeftOutAndTold() {
    assertThat(table("a;b\n1\n1;2\n1;2;3\n").rows()).hasSize(1);
    assertThat(faults)
        .containsExactly(
            "a.csv:2:1: the row has 1 values, but the header has 2 columns",
            "a.csv:4:1: the row has 3 values, but the header has 2 columns");
  }

  @Test
  void otherEncodingsAreRefused() {
    byte[] bytes = "a;b\n\u00e4;1\n".getBytes(StandardCharsets.ISO_8859_1);
    assertThat(CsvTable.parse("a.csv", bytes, hears)).isEmpty();
    assertThat(faults).singleElement().asString().startsWith("a.csv:2:1: the file is not UTF-8");
  }

  private CsvTable table(String text, CsvColumnSpec form) {
    return CsvTable.parse("a.csv", text, form, hears).orElseThrow();
  }

  @Test
  void theSeparatorIsTheFirstThatDividesTheHeaderIntoWhatIsNeeded() {
    List<String> needed = List.of("t", "X", "y", "z");
    assertThat(CsvDelimiter.of("t,x,y,z,a;b;c;d;e;f\n", needed)).isEqualTo(CsvDelimiter.COMMA);
    assertThat(CsvDelimiter.of("t;x;y;z;\"a\";b,c,d,e,f,g\n", needed))
        .isEqualTo(CsvDelimiter.SEMICOLON);
    assertThat(CsvDelimiter.of("t\tx\ty\tz\tb,c,d,e,f,g\n", needed)).isEqualTo(CsvDelimiter.TAB);
    assertThat(CsvDelimiter.of("t;x;y\n", needed)).isEqualTo(CsvDelimiter.SEMICOLON);
  }

  @Test
  void surplusCellsThatAreEmptyDoNotCount() {
    CsvTable table = table("a,b\n1,2,\n3,4, ,\n5,6");
    assertThat(table.rows()).extracting(row -> row.cell("b")).containsExactly("2", "4", "6");
    assertThat(faults).isEmpty();
    table("a,b\n1,2,,3\n");
    assertThat(faults).singleElement().asString().startsWith("a.csv:2:1: the row has 4 values");
  }

  @Test
  void aRowMayLackColumnsThatAreNotNeeded() {
    CsvColumnSpec form = CsvColumnSpec.of(List.of("a", "b"));
    CsvTable table = table("a,b,note\n1,2\n3,4,x\n", form);
    assertThat(table.rows()).extracting(row -> row.cell("note")).containsExactly("", "x");
    assertThat(table.rows().get(0).location("note").line()).isEqualTo(2);
    assertThat(faults).isEmpty();
    assertThat(table("a,b,note\n1\n3,4", form).rows()).isEmpty();
    assertThat(faults).hasSize(2);
  }

  @Test
  void rowsAreFilledUpAndTheLastColumnOfANameCountsWhereTheReaderSaysSo() {
    CsvColumnSpec form = new CsvColumnSpec(List.of("a", "b"), true, true);
    CsvTable table = table("a,b,a\n1,2,3\n4\n\n5,6", form);
    assertThat(table.require(form.needed(), "a,b")).isTrue();
    assertThat(table.rows()).extracting(row -> row.cell("a")).containsExactly("3", "", "");
    assertThat(table.rows()).extracting(row -> row.cell("b")).containsExactly("2", "", "6");
    assertThat(faults).isEmpty();
  }
}
