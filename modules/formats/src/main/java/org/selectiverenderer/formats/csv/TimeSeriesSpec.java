package org.selectiverenderer.formats.csv;

import java.util.List;

/**
 * The format that a time series table must have.
 *
 * @param subject the noun for it in messages, such as {@code the path}
 * @param refusal the consequence of an error, such as {@code the path is not played}
 * @param needed names of the required columns; the first is the time
 * @param together names of columns of which all or none must be present
 * @param strict whether times must increase strictly; otherwise equal times are allowed
 * @param torn whether an incomplete last row, as a crash of its writer leaves it, is ignored
 * @param gaps whether the {@code together} columns may all be empty in a row; they are then read as
 *     NaN
 */
public record TimeSeriesSpec(
    String subject,
    String refusal,
    List<String> needed,
    List<String> together,
    boolean strict,
    boolean torn,
    boolean gaps) {
  /** Makes defensive copies of the lists. */
  public TimeSeriesSpec {
    needed = List.copyOf(needed);
    together = List.copyOf(together);
  }

  /** Returns the required columns. */
  CsvColumnSpec columns() {
    return CsvColumnSpec.of(needed);
  }

  /** Returns the allowed headers, for messages. */
  String headers() {
    String least = String.join(",", needed);
    return together.isEmpty() ? least : least + " or " + least + "," + String.join(",", together);
  }
}
