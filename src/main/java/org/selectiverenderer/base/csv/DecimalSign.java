package org.selectiverenderer.base.csv;

import java.util.Optional;

/**
 * The decimal sign of a table's numbers: whichever the first number has that has one. A comma
 * before exactly three digits may separate thousands, and counts only where semicolons separate
 * cells.
 */
final class DecimalSign {
  private static final int THOUSAND = 3;

  private final boolean semicolons;
  private String first = "";
  private int firstLine;

  DecimalSign(Separator separator) {
    semicolons = separator == Separator.SEMICOLON;
  }

  /** A cell's text with a decimal point for the decimal comma that it may have. */
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

  /** What is wrong with the decimal sign of a number, if it has another than those before it. */
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
                CsvNumbers.quoted(number),
                words[comma ? 1 : 0],
                CsvNumbers.quoted(first),
                firstLine,
                words[comma ? 0 : 1]));
  }
}
