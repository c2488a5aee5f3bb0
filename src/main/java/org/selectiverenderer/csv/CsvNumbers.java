package org.selectiverenderer.csv;

import java.util.OptionalDouble;

/** Numbers as cells write them: with a decimal point, whatever the locale. */
public final class CsvNumbers {
  private static final int SHOWN = 40;

  private CsvNumbers() {}

  /** The finite number of a cell, else empty, of which {@code faults} has heard. */
  public static OptionalDouble number(CsvRow row, String column, CsvFaults faults) {
    String text = row.cell(column);
    if (text.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?")) {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return OptionalDouble.of(value);
      }
    }
    String hint =
        text.matches("[+-]?\\d+,\\d+") ? " (write it with a decimal point, not with a comma)" : "";
    faults.fault(
        row.location(column),
        text.isEmpty() ? "a number is missing" : quoted(text) + " is no number" + hint);
    return OptionalDouble.empty();
  }

  /** A cell's text for a message, shortened. */
  public static String quoted(String text) {
    return "'" + (text.length() > SHOWN ? text.substring(0, SHOWN) + "..." : text) + "'";
  }
}
