package org.selectiverenderer.base.csv;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.apache.commons.csv.CSVFormat;

/**
 * Writes a table: commas between the cells, quotation marks round those that need them (RFC 4180),
 * every row ended by LF whatever the platform. Not safe for use by several threads.
 */
public final class CsvText {
  private static final CSVFormat FORMAT =
      CSVFormat.RFC4180.builder().setRecordSeparator("\n").get();

  private final StringBuilder text = new StringBuilder();
  private final boolean bare;

  /** Also quotes cells that a spreadsheet might trim or take for a comment: {@code #1}. */
  public CsvText() {
    this(false);
  }

  private CsvText(boolean bare) {
    this.bare = bare;
  }

  /** Quotes no cell but those with a comma, a quotation mark or an end of line. */
  public static CsvText bare() {
    return new CsvText(true);
  }

  /** Adds a row; numbers with decimals come as text. */
  public CsvText row(Object... cells) {
    if (bare) {
      text.append(Arrays.stream(cells).map(CsvText::quoted).collect(Collectors.joining(",")));
      text.append('\n');
      return this;
    }
    try {
      FORMAT.printRecord(text, cells);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // a StringBuilder does not fail
    }
    return this;
  }

  /** Adds a row. */
  public CsvText row(List<?> cells) {
    return row(cells.toArray());
  }

  /** One row with its end, {@link #bare}. */
  public static String line(Object... cells) {
    return bare().row(cells).toString();
  }

  private static String quoted(Object value) {
    String cell = value.toString();
    boolean plain = cell.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? cell : '"' + cell.replace("\"", "\"\"") + '"';
  }

  /** All rows, the last one ended. */
  @Override
  public String toString() {
    return text.toString();
  }
}
