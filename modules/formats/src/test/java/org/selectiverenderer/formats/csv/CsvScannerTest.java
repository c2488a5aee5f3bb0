package org.selectiverenderer.formats.csv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class CsvScannerTest {
  private static final String BROKEN = "broken";

  @ParameterizedTest
  @EnumSource(CsvDelimiter.class)
  void readsWhatCommonsCsvReads(CsvDelimiter separator) {
    String letters = "ab \"\"" + separator.character() + separator.character() + "\t\n\r\u00a0";
    Random random = new Random(1);
    for (int i = 0; i < 50_000; i++) {
      StringBuilder text = new StringBuilder();
      for (int length = random.nextInt(14); length > 0; length--) {
        text.append(letters.charAt(random.nextInt(letters.length())));
      }
      String table = text.toString();
      assertThat(scanned(table, separator)).as(table).isEqualTo(parsed(table, separator));
    }
  }

  private static List<Object> scanned(String text, CsvDelimiter separator) {
    CsvScanner scan = new CsvScanner(text, separator);
    List<Object> records = new ArrayList<>();
    while (scan.next()) {
      records.add(List.of(scan.cells(scan.start(), scan.cells())));
    }
    if (scan.broken()) {
      records.add(BROKEN);
    }
    return records;
  }

  private static List<Object> parsed(String text, CsvDelimiter separator) {
    CSVFormat format =
        CSVFormat.RFC4180
            .builder()
            .setDelimiter(separator.character())
            .setIgnoreEmptyLines(true)
            .setIgnoreSurroundingSpaces(true)
            .get();
    List<Object> records = new ArrayList<>();
    try (CSVParser parser = CSVParser.parse(text, format)) {
      for (CSVRecord cells : parser) {
        records.add(cells.stream().map(String::strip).toList());
      }
    } catch (IOException | UncheckedIOException e) {
      records.add(BROKEN);
    }
    return records;
  }

  @Test
  void linesOfEveryKindCount() {
    CsvScanner scan = new CsvScanner("a,b\r\n\r\"1\r\n2\n3\r\",x\n\n4,5\r6,7", CsvDelimiter.COMMA);
    List<Integer> lines = new ArrayList<>();
    while (scan.next()) {
      lines.add(scan.startLine());
    }
    assertThat(lines).containsExactly(1, 3, 8, 9);
    assertThat(scan.last()).isTrue();
  }
}
