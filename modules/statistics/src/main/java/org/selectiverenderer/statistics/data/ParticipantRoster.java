package org.selectiverenderer.statistics.data;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;

/**
 * The participants of a study with their conditions, read from a CSV file {@code
 * participant[,condition]}.
 */
public final class ParticipantRoster {
  private record Entry(String condition, SourceLocation location) {}

  private final Map<String, Entry> entries;

  private ParticipantRoster(Map<String, Entry> entries) {
    this.entries = entries;
  }

  /**
   * Reads a file.
   *
   * @return empty when the file has faults, which are reported to {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<ParticipantRoster> read(Path path, ProblemCollector problems)
      throws IOException {
    ProblemCollector faults = new ProblemCollector(problems::add);
    Optional<CsvTable> table =
        CsvTable.read(
            path,
            CsvColumnSpec.of(List.of("participant")),
            (at, what) -> faults.error(at, what + "; nothing is analysed"));
    if (table.isEmpty() || !table.get().require(List.of("participant"), "participant,condition")) {
      return Optional.empty();
    }
    Map<String, Entry> entries = new LinkedHashMap<>();
    for (CsvRow row : table.get().rows()) {
      String condition = table.get().has("condition") ? row.cell("condition") : "";
      String id = row.cell("participant");
      if (id.isEmpty()) {
        faults.error(
            row.location("participant"), "the participant is missing; nothing is analysed");
      } else if (entries.putIfAbsent(id, new Entry(condition, row.location())) != null) {
        faults.error(
            row.location("participant"),
            "participant " + id + " is listed twice; nothing is analysed");
      }
    }
    return faults.any() ? Optional.empty() : Optional.of(new ParticipantRoster(entries));
  }

  boolean has(String participant) {
    return entries.containsKey(participant);
  }

  /** Returns the condition of a participant; empty when the roster does not state it. */
  Optional<String> condition(String participant) {
    return Optional.ofNullable(entries.get(participant))
        .map(Entry::condition)
        .filter(condition -> !condition.isEmpty());
  }

  /** Returns the participants with their locations in the roster's file. */
  Map<String, SourceLocation> places() {
    Map<String, SourceLocation> places = new LinkedHashMap<>();
    entries.forEach((id, entry) -> places.put(id, entry.location()));
    return places;
  }
}
