package org.selectiverenderer.formats.csv;

import java.util.List;

/**
 * The columns that a reader requires of a CSV table, and how strictly rows must match the header.
 *
 * @param needed names that the header must have, in any letter case and any order; the separator is
 *     also detected by them
 * @param filledUp whether a row may be shorter than the header, its missing cells being read as
 *     empty; otherwise only columns after the last needed one may be missing
 * @param lastCounts whether a header may repeat a column name, in which case the last column of
 *     that name is read; otherwise a repeated name is an error
 */
public record CsvColumnSpec(List<String> needed, boolean filledUp, boolean lastCounts) {
  /** No required columns; every row must have as many cells as the header. */
  static final CsvColumnSpec ANY = of(List.of());

  /** Makes a defensive copy of the list. */
  public CsvColumnSpec {
    needed = List.copyOf(needed);
  }

  /** Requires each column once in the header, and a cell in each of them in every row. */
  public static CsvColumnSpec of(List<String> needed) {
    return new CsvColumnSpec(needed, false, false);
  }
}
