package org.selectiverenderer.base.csv;

import java.util.List;

/**
 * What a reader needs of a table's columns.
 *
 * @param needed names that the header must have, in any case and any order; they also tell the
 *     separator
 * @param filledUp whether a row may end before any column, whose cell is then empty; else it may
 *     end only behind the last needed one
 * @param lastCounts whether a header may name a column again, and the last one counts; else that is
 *     a fault
 */
public record CsvColumns(List<String> needed, boolean filledUp, boolean lastCounts) {
  /** Nothing is known of the header; every row must be as long as it. */
  static final CsvColumns ANY = of(List.of());

  /** Keeps copies, so that it stays as it is. */
  public CsvColumns {
    needed = List.copyOf(needed);
  }

  /** Each is named once, and every row goes as far as these. */
  public static CsvColumns of(List<String> needed) {
    return new CsvColumns(needed, false, false);
  }
}
