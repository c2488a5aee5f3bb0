package org.selectiverenderer.base.csv;

import java.util.List;

/**
 * What a table of numbers over time must look like.
 *
 * @param subject what it is called in messages, such as {@code the path}
 * @param refusal what is not done with a faulty one, such as {@code the path is not played}
 * @param needed names of columns that must be there; the first is the time
 * @param together names of columns of which all or none must be there
 * @param strict whether every time must be later than the one before; else it may be the same
 * @param torn whether a last row that was not written whole is passed over, as a crash leaves it
 * @param gaps whether the columns that go together may be empty in a row, all of them; each is then
 *     not a number
 */
public record TableForm(
    String subject,
    String refusal,
    List<String> needed,
    List<String> together,
    boolean strict,
    boolean torn,
    boolean gaps) {
  /** Keeps copies, so that it stays as it is. */
  public TableForm {
    needed = List.copyOf(needed);
    together = List.copyOf(together);
  }

  /** What the header must have. */
  CsvColumns columns() {
    return CsvColumns.of(needed);
  }

  /** The header, or headers, that it may have. */
  String headers() {
    String least = String.join(",", needed);
    return together.isEmpty() ? least : least + " or " + least + "," + String.join(",", together);
  }
}
