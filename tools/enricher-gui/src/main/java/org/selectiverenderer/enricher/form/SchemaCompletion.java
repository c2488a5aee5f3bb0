package org.selectiverenderer.enricher.form;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** Schemas in a line of text, separated by commas, and what may complete them. */
final class SchemaCompletion {
  private SchemaCompletion() {}

  /** The schemas that a line names. */
  static List<String> parse(String line) {
    return Arrays.stream(line.split(","))
        .map(String::strip)
        .filter(schema -> !schema.isEmpty())
        .distinct()
        .toList();
  }

  /** The line that names schemas. */
  static String text(List<String> schemas) {
    return String.join(", ", schemas);
  }

  /** Known schemas that go on from the word at the caret, without those that the line names. */
  static List<String> proposals(String line, int caret, List<String> known) {
    String word = line.substring(start(line, caret), caret).strip().toLowerCase(Locale.ROOT);
    Set<String> others = new HashSet<>(parse(line));
    return known.stream()
        .filter(schema -> schema.toLowerCase(Locale.ROOT).startsWith(word))
        .filter(schema -> !others.contains(schema))
        .toList();
  }

  /** The line with the word at the caret replaced. */
  static String accept(String line, int caret, String schema) {
    String before = line.substring(0, start(line, caret)).stripTrailing();
    int comma = line.indexOf(',', caret);
    String behind = comma < 0 ? "" : line.substring(comma);
    return (before.isEmpty() ? "" : before + " ") + schema + behind;
  }

  private static int start(String line, int caret) {
    return line.lastIndexOf(',', caret - 1) + 1;
  }
}
