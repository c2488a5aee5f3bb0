package org.selectiverenderer.formats.csv;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/** Parses the numbers in cells, independent of the locale; the package describes decimal commas. */
public final class CsvNumberParser {
  private static final Pattern WITH_COMMA = Pattern.compile("[+-]?\\d+,\\d+");
  private static final int SHOWN = 40;

  private CsvNumberParser() {}

  /**
   * Returns the finite number in a cell; empty after an error, which {@code faults} has received.
   */
  public static OptionalDouble number(CsvRow row, String column, CsvErrorHandler faults) {
    String text = row.cell(column);
    String plain = row.withPoint(text);
    if (isNumber(plain)) {
      double value = Double.parseDouble(plain);
      Optional<String> clash = row.decimalClash(text);
      if (Double.isFinite(value) && clash.isEmpty()) {
        return OptionalDouble.of(value);
      }
      if (clash.isPresent()) {
        faults.fault(row.location(column), clash.get());
        return OptionalDouble.empty();
      }
    }
    faults.fault(
        row.location(column),
        text.isEmpty()
            ? "a number is missing"
            : quoted(text) + " is not a number" + commaHint(row, column));
    return OptionalDouble.empty();
  }

  /** Returns whether a text matches {@code [+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?}. */
  private static boolean isNumber(String text) {
    int from = behindSign(text, 0);
    int point = behindDigits(text, from);
    int at = text.startsWith(".", point) ? behindDigits(text, point + 1) : point;
    if (at - from == (at == point ? 0 : 1)) {
      return false; // no digit before the point and none behind it
    }
    if (at < text.length() && (text.charAt(at) == 'e' || text.charAt(at) == 'E')) {
      int exponent = behindSign(text, at + 1);
      at = behindDigits(text, exponent);
      return at == text.length() && at > exponent;
    }
    return at == text.length();
  }

  private static int behindSign(String text, int at) {
    return text.startsWith("-", at) || text.startsWith("+", at) ? at + 1 : at;
  }

  private static int behindDigits(String text, int from) {
    int at = from;
    while (at < text.length() && text.charAt(at) >= '0' && text.charAt(at) <= '9') {
      at++;
    }
    return at;
  }

  /** Returns a hint for a refused cell that looks like a number with a decimal comma, else "". */
  public static String commaHint(CsvRow row, String column) {
    return WITH_COMMA.matcher(row.decimal(column)).matches()
        ? " (write it with a decimal point, not a comma)"
        : "";
  }

  /** Returns a cell's text in quotes for a message, shortened if it is long. */
  public static String quoted(String text) {
    return "'" + (text.length() > SHOWN ? text.substring(0, SHOWN) + "..." : text) + "'";
  }
}
