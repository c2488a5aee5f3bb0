package org.selectiverenderer.formats.csv;

import java.util.regex.Pattern;

/**
 * Marks text that a spreadsheet would calculate. A cell that begins with {@code = + - @} is a
 * formula to it, which may send the table to whoever wrote the cell; an apostrophe before it says
 * that it is text. Where a spreadsheet expects other separators than commas, a cell also begins
 * within the text, after a semicolon, a tab or a line end. Numbers have no mark. {@link CsvTable}
 * removes the marks again.
 */
public final class SpreadsheetText {
  private static final String CELL = "(^|[;\\t\\r\\n])";

  private static final String FORMULA =
      "(?='*[ \\x0b\\f\\u00a0\\u3000]*[=+\\-@\uff1d\uff0b\uff0d\uff20].)";

  /** A number, perhaps with the stars of its significance. */
  private static final String NUMBER =
      "[+-](?:(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?\\*{0,3}|Infinity|Inf|inf)";

  private static final Pattern UNMARKED =
      Pattern.compile(
          CELL
              + "(?!%s$|(?<=[;\\t\\r\\n])%s(?:[;\\t\\r\\n]|$))".formatted(NUMBER, NUMBER)
              + FORMULA,
          Pattern.DOTALL);
  private static final Pattern MARKED = Pattern.compile(CELL + "'" + FORMULA, Pattern.DOTALL);

  private SpreadsheetText() {}

  /** Returns the content of a cell, with marks where it would be calculated. */
  public static String marked(String cell) {
    return UNMARKED.matcher(cell).replaceAll("$1'");
  }

  /** Returns the content of a cell without the marks. */
  static String plain(String cell) {
    return MARKED.matcher(cell).replaceAll("$1");
  }
}
