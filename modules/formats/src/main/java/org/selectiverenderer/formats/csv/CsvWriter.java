package org.selectiverenderer.formats.csv;

import java.util.List;

/**
 * Writes a CSV table: commas between the cells, quotation marks around those that need them (RFC
 * 4180), and LF after every row on every platform. Not thread-safe.
 */
public final class CsvWriter {
  private final StringBuilder text = new StringBuilder();
  private final boolean bare;

  /**
   * Creates a writer of tables for spreadsheets too: it also quotes cells which a spreadsheet might
   * trim or read as a comment ({@code #1}), and marks text that one would calculate ({@link
   * SpreadsheetText}).
   */
  public CsvWriter() {
    this(false);
  }

  private CsvWriter(boolean bare) {
    this.bare = bare;
  }

  /**
   * Returns a writer of tables for programs: it quotes only cells with a comma, a quotation mark or
   * a line end.
   */
  public static CsvWriter bare() {
    return new CsvWriter(true);
  }

  /** Adds a row; the caller formats fractional numbers as text. */
  public CsvWriter row(Object... cells) {
    for (int i = 0; i < cells.length; i++) {
      String cell = cells[i].toString();
      if (!bare && cells[i] instanceof String) {
        cell = SpreadsheetText.marked(cell);
      }
      boolean quoted = mustBeQuoted(cell) || !bare && mayBeMisread(cell, i == 0);
      text.append(i == 0 ? "" : ",");
      text.append(quoted ? '"' + cell.replace("\"", "\"\"") + '"' : cell);
    }
    text.append('\n');
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

  private static boolean mustBeQuoted(String cell) {
    return cell.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
  }

  /**
   * Returns whether a reader may trim a cell, take it for a comment, or, where it is empty and the
   * first, skip its row as an empty line.
   */
  private static boolean mayBeMisread(String cell, boolean first) {
    return cell.isEmpty() ? first : cell.charAt(0) <= '#' || cell.charAt(cell.length() - 1) <= ' ';
  }

  /** Returns all rows, each with its line end. */
  @Override
  public String toString() {
    return text.toString();
  }
}
