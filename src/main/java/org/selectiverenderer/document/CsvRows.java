package org.selectiverenderer.document;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;
import org.selectiverenderer.x3d.EncodedText;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/** The rows of a table that an author brings: a header, then rows; commas, or semicolons. */
public final class CsvRows {
  /**
   * A row.
   *
   * @param at its place, for messages
   */
  public record Row(Location at, Map<String, String> cells) {
    /** A cell without spaces around it; empty where the row is too short. */
    public String cell(String column) {
      return cells.getOrDefault(column, "");
    }
  }

  private CsvRows() {}

  /**
   * Reads a table.
   *
   * @param name of the file, for messages
   * @param columns that it must have, in any order and any case; further ones are let be
   * @return empty if a column is missing or it is no table, which is reported
   */
  public static Optional<List<Row>> read(
      String name, byte[] bytes, List<String> columns, Problems problems) {
    String text = EncodedText.of(bytes).characters();
    int end = text.indexOf('\n');
    String head = end < 0 ? text : text.substring(0, end);
    char separator = head.indexOf(';') >= 0 && head.indexOf(',') < 0 ? ';' : ',';
    CSVFormat format =
        CSVFormat.DEFAULT
            .builder()
            .setDelimiter(separator)
            .setIgnoreSurroundingSpaces(true)
            .setIgnoreEmptyLines(true)
            .get();
    try (CSVParser parser = CSVParser.parse(new StringReader(text), format)) {
      return rows(name, parser, columns, problems);
    } catch (UncheckedIOException | IOException e) {
      problems.error(
          Location.of(name), "this is no table of values separated by commas; nothing is read");
      return Optional.empty();
    }
  }

  private static Optional<List<Row>> rows(
      String name, CSVParser parser, List<String> columns, Problems problems) {
    List<String> header = new ArrayList<>();
    List<Row> rows = new ArrayList<>();
    long line = 1;
    for (CSVRecord record : parser) {
      Location at = new Location(name, (int) line, 1);
      line = parser.getCurrentLineNumber() + 1;
      if (header.isEmpty()) {
        record.forEach(cell -> header.add(cell.strip().toLowerCase(Locale.ROOT)));
        continue;
      }
      Map<String, String> cells = new LinkedHashMap<>();
      for (int i = 0; i < Math.min(header.size(), record.size()); i++) {
        cells.put(header.get(i), record.get(i).strip());
      }
      rows.add(new Row(at, cells));
    }
    if (!header.containsAll(columns)) {
      problems.error(
          new Location(name, 1, 1),
          "the first line names the columns %s; nothing is read without it"
              .formatted(String.join(",", columns)));
      return Optional.empty();
    }
    return Optional.of(rows);
  }
}
