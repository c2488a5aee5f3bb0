package org.selectiverenderer.formats.csv;

import java.util.Optional;

/**
 * The decimal separator of a table's numbers: that of the first number with a fraction. A comma
 * before exactly three digits may be a thousands separator, and is taken for a decimal comma only
 * where semicolons separate the cells.
 */
final class DecimalSeparator {
  private static final int THOUSAND = 3;

  private final boolean semicolons;
  private String first = "";
  private int firstLine;

  DecimalSeparator(CsvDelimiter separator) {
    semicolons = separator == CsvDelimiter.SEMICOLON;
  }

  /** Returns a cell's text with its decimal comma, if any, replaced by a decimal point. */
  String withPoint(String cell) {
    int comma = cell.indexOf(',');
    if (comma < 0 || cell.indexOf('.') >= 0 || cell.indexOf(',', comma + 1) >= 0) {
      return cell;
    }
    return semicolons || digits(cell, comma + 1) != THOUSAND ? cell.replace(',', '.') : cell;
  }

  private static int digits(String text, int from) {
    int at = from;
    while (at < text.length() && text.charAt(at) >= '0' && text.charAt(at) <= '9') {
      at++;
    }
    return at - from;
  }

  /** Returns an error message if a number has another decimal sign than those before it. */
  Optional<String> clash(String number, int line) {
    boolean comma = number.indexOf(',') >= 0;
    if (!comma && number.indexOf('.') < 0) {
      return Optional.empty();
    }
    if (first.isEmpty()) {
      first = number;
      firstLine = line;
    }
    if (comma == first.indexOf(',') >= 0) {
      return Optional.empty();
    }
    String[] words = {"point", "comma"};
    return Optional.of(
        "%s has a decimal %s where %s in line %s has a decimal %s"
            .formatted(
                CsvNumberParser.quoted(number),
                words[comma ? 1 : 0],
                CsvNumberParser.quoted(first),
                firstLine,
                words[comma ? 0 : 1]));
  }
}
