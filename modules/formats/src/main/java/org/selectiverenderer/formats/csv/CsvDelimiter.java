package org.selectiverenderer.formats.csv;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** The delimiter between the cells of a CSV table. */
enum CsvDelimiter {
  COMMA(','),
  TAB('\t'),
  SEMICOLON(';');

  private final char character;

  CsvDelimiter(char character) {
    this.character = character;
  }

  char character() {
    return character;
  }

  /**
   * Detects the delimiter that occurs most often in the header outside quotation marks; a comma if
   * there is none, and the first in the order of this enum in a tie.
   *
   * @param text the table, its header being the first line that is not empty
   */
  static CsvDelimiter of(String text) {
    return of(text, List.of());
  }

  /**
   * Detects the first delimiter, in the order of this enum, that splits the header into cells that
   * include the needed names; if none does, the result of {@link #of(String)}.
   */
  static CsvDelimiter of(String text, List<String> needed) {
    if (!needed.isEmpty()) {
      Set<String> wanted = needed.stream().map(CsvTable::key).collect(Collectors.toSet());
      for (CsvDelimiter each : values()) {
        CsvScanner scan = new CsvScanner(text, each);
        if (scan.next()
            && Arrays.stream(scan.cells(scan.start(), scan.cells()))
                .map(CsvTable::key)
                .collect(Collectors.toSet())
                .containsAll(wanted)) {
          return each;
        }
      }
    }
    return most(text);
  }

  private static CsvDelimiter most(String text) {
    int[] counts = new int[values().length];
    boolean quoted = false;
    boolean begun = false;
    for (int at = 0; at < text.length(); at++) {
      char c = text.charAt(at);
      if (c == '"') {
        quoted = !quoted;
      } else if (!quoted && (c == '\n' || c == '\r')) {
        if (begun) {
          break;
        }
        continue;
      } else if (!quoted) {
        for (CsvDelimiter each : values()) {
          counts[each.ordinal()] += c == each.character ? 1 : 0;
        }
      }
      begun = true;
    }
    CsvDelimiter most = COMMA;
    for (CsvDelimiter each : values()) {
      most = counts[each.ordinal()] > counts[most.ordinal()] ? each : most;
    }
    return most;
  }
}
