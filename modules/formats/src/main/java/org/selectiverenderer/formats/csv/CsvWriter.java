package org.selectiverenderer.formats.csv;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.apache.commons.csv.CSVFormat;

/**
 * Writes a CSV table: commas between the cells, quotation marks around those that need them (RFC
 * 4180), and LF after every row on every platform. Not thread-safe.
 */
public final class CsvWriter {
  private static final CSVFormat FORMAT =
      CSVFormat.RFC4180.builder().setRecordSeparator("\n").get();

  private final StringBuilder text = new StringBuilder();
  private final boolean bare;

  /**
   * Creates a writer that also quotes cells which a spreadsheet might trim or read as a comment
   * ({@code #1}).
   */
  public CsvWriter() {
    this(false);
  }

  private CsvWriter(boolean bare) {
    this.bare = bare;
  }

  /** Returns a writer that quotes only cells with a comma, a quotation mark or a line end. */
  public static CsvWriter bare() {
    return new CsvWriter(true);
  }

  /** Adds a row; the caller formats fractional numbers as text. */
  public CsvWriter row(Object... cells) {
    if (bare) {
      text.append(Arrays.stream(cells).map(CsvWriter::quoted).collect(Collectors.joining(",")));
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
  public CsvWriter row(List<?> cells) {
    return row(cells.toArray());
  }

  /** Returns one row with its line end, quoted as by {@link #bare}. */
  public static String line(Object... cells) {
    return bare().row(cells).toString();
  }

  private static String quoted(Object value) {
    String cell = value.toString();
    boolean plain = cell.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? cell : '"' + cell.replace("\"", "\"\"") + '"';
  }

  /** Returns all rows, each with its line end. */
  @Override
  public String toString() {
    return text.toString();
  }
}
