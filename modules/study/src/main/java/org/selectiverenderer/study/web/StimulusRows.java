package org.selectiverenderer.study.web;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.StimulusList.Stimulus;

/**
 * Finds the row of a stimulus list that a participant saw. The list may have been sorted since, or
 * have got other rows: a row is the same if all its cells are.
 */
final class StimulusRows {
  /** The page shows a cell as a text, of which nobody reads more. */
  private static final int LONGEST = 100_000;

  private static final Pattern CONTROLS = Pattern.compile("[\\p{Cntrl}\\x80-\\x9f&&[^\\n\\r\\t]]");

  private final Map<Integer, Stimulus> lines = new HashMap<>();
  private final Map<Map<String, String>, Stimulus> contents = new HashMap<>();

  StimulusRows(StimulusList list) {
    for (Stimulus row : list.rows()) {
      lines.put(row.line(), row);
      // Rows that are alike show the same.
      contents.putIfAbsent(cleaned(row.cells()), row);
    }
  }

  /** Returns whether a line of the list still has these cells. */
  boolean inPlace(int line, Map<String, String> cells) {
    Stimulus there = lines.get(line);
    return there != null && cleaned(there.cells()).equals(cells);
  }

  /** Returns the row with these cells, which another line may have now; empty for none. */
  Optional<Stimulus> row(Map<String, String> cells) {
    return Optional.ofNullable(contents.get(cells));
  }

  /**
   * Reads the cells that a record names.
   *
   * @throws IllegalArgumentException if one is too long, with a sentence
   */
  static Map<String, String> cells(JsonNode json) {
    Map<String, String> cells = new LinkedHashMap<>();
    json.properties().forEach(cell -> cells.put(cell.getKey(), cell.getValue().asText()));
    cells.forEach(
        (column, cell) -> {
          if (cell.length() > LONGEST) {
            throw new IllegalArgumentException(
                "the cell %s of the stimulus has more than %d characters"
                    .formatted(RecordFaults.quoted(column), LONGEST));
          }
        });
    return cleaned(cells);
  }

  /** Returns cells in which spaces replace control characters other than line breaks and tabs. */
  static Map<String, String> cleaned(Map<String, String> cells) {
    Map<String, String> cleaned = new LinkedHashMap<>(cells);
    cleaned.replaceAll((column, cell) -> CONTROLS.matcher(cell).replaceAll(" "));
    return cleaned;
  }
}
