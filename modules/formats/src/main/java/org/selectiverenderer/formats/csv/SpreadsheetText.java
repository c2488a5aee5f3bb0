package org.selectiverenderer.formats.csv;

import java.util.regex.Pattern;

/**
 * Marks text that a spreadsheet would calculate. A cell that begins with {@code = + - @} is a
 * formula to it, which may send the table to whoever wrote the cell; an apostrophe before it says
 * that it is text. Numbers have no mark. {@link CsvTable} removes the mark again.
 */
public final class SpreadsheetText {
  private static final Pattern FORMULA =
      Pattern.compile("'*[\\s\\u00a0\\u3000]*[=+\\-@\uff1d\uff0b\uff0d\uff20].+", Pattern.DOTALL);

  /** A number, perhaps with the stars of its significance. */
  private static final Pattern NUMBER =
      Pattern.compile("[+-](\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?\\*{0,3}|[+-](Infinity|Inf|inf)");

  private SpreadsheetText() {}

  /** Returns the content of a cell, with the mark if it would be calculated. */
  public static String marked(String cell) {
    return formula(cell) && !NUMBER.matcher(cell).matches() ? "'" + cell : cell;
  }

  /** Returns the content of a cell without the mark. */
  static String plain(String cell) {
    return cell.startsWith("'") && formula(cell) ? cell.substring(1) : cell;
  }

  private static boolean formula(String cell) {
    return FORMULA.matcher(cell).matches();
  }
}
