package org.selectiverenderer.formats.csv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Random;
import org.apache.commons.csv.CSVFormat;
import org.junit.jupiter.api.Test;

class CsvWriterTest {
  @Test
  void rowsAreWrittenAsCommonsCsvWritesThem() throws IOException {
    CSVFormat format = CSVFormat.RFC4180.builder().setRecordSeparator("\n").get();
    String letters = "ab \"\",;#!$\t\n\r\u00a0\u00e4\u0000";
    Random random = new Random(1);
    for (int i = 0; i < 50_000; i++) {
      Object[] cells = new Object[1 + random.nextInt(3)];
      for (int c = 0; c < cells.length; c++) {
        StringBuilder cell = new StringBuilder();
        for (int length = random.nextInt(5); length > 0; length--) {
          cell.append(letters.charAt(random.nextInt(letters.length())));
        }
        cells[c] = random.nextInt(9) == 0 ? -i : cell.toString();
      }
      StringBuilder expected = new StringBuilder();
      format.printRecord(expected, cells);
      assertThat(new CsvWriter().row(cells)).hasToString(expected.toString());
    }
  }

  @Test
  void cellsAreQuotedWhereTheyMustBe() {
    assertThat(new CsvWriter().row("a", "b c", "d;e", 1).row("x,y", "say \"z\"", "", "\n"))
        .hasToString("a,b c,d;e,1\n\"x,y\",\"say \"\"z\"\"\",,\"\n\"\n");
  }

  @Test
  void whatIsWrittenIsReadAgain() {
    List<String> cells = List.of("a,b", "\"", "#1", " c ", "\u00e4\n\u00f6", "");
    String text = CsvWriter.line("1", "2", "3", "4", "5", "6") + new CsvWriter().row(cells);
    CsvRow row = CsvTable.parse("a.csv", text, (at, fault) -> {}).orElseThrow().rows().get(0);
    for (int i = 0; i < cells.size(); i++) {
      assertThat(row.cell(Integer.toString(i + 1))).isEqualTo(cells.get(i).strip());
    }
  }

  @Test
  void bareRowsAreQuotedForCommasQuotationMarksAndLineEndsOnly() {
    assertThat(CsvWriter.bare().row("", "#1", "!a ", 1).row("a,b", "\"", "\n", "\r"))
        .hasToString(",#1,!a ,1\n\"a,b\",\"\"\"\",\"\n\",\"\r\"\n");
    assertThat(CsvWriter.line("#1", "")).isEqualTo("#1,\n");
  }

  @Test
  void otherRowsAreAlsoQuotedWhereASpreadsheetMightTakeThemForSomethingElse() {
    assertThat(new CsvWriter().row("#1", "a ").row("", "b")).hasToString("\"#1\",\"a \"\n\"\",b\n");
  }
}
