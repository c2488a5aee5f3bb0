package org.selectiverenderer.enricher.overview;

import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.schema.ConsistencyDegree;

/**
 * A value that an author writes into a cell: {@code high} or {@code h}, {@code low} or {@code l}, a
 * number from 0 to 1 with a decimal point or comma, or nothing, which clears the cell.
 *
 * @param degree empty to clear
 */
record CellInput(Optional<ConsistencyDegree> degree) {
  /** Parses a text; empty if it is none of these. */
  static Optional<CellInput> of(String text) {
    // A cell shows a degree in parentheses where it only follows from the version's position.
    String word = text.strip().toLowerCase(Locale.ROOT).replaceAll("[()]", "");
    return switch (word) {
      case "" -> Optional.of(new CellInput(Optional.empty()));
      case "h" -> Optional.of(new CellInput(Optional.of(ConsistencyDegree.HIGH)));
      case "l" -> Optional.of(new CellInput(Optional.of(ConsistencyDegree.LOW)));
      default ->
          ConsistencyDegree.of(word.replace(',', '.')).map(d -> new CellInput(Optional.of(d)));
    };
  }
}
