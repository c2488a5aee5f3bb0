package org.selectiverenderer.study.analysis;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.formats.csv.SpreadsheetText;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialColumns;

/**
 * A table of trials as {@code experiment collect --trials} writes it. Trials of practice blocks do
 * not count.
 *
 * @param rows the trials that count, in the order of the table
 */
public record StudyTrials(CsvTable table, List<CsvRow> rows, DataSource source) {
  public StudyTrials {
    rows = List.copyOf(rows);
  }

  /**
   * Reads a table.
   *
   * @param file its name, for messages
   * @return empty if it is no table of this study's trials, which is reported to {@code problems}
   */
  public static Optional<StudyTrials> read(
      String file,
      byte[] content,
      DataSource source,
      StudyDesign design,
      ProblemCollector problems) {
    Optional<CsvTable> table =
        CsvTable.parse(file, content, (at, message) -> problems.error(at, message));
    List<String> needed = new ArrayList<>(TrialColumns.FIRST);
    needed.addAll(design.factorNames());
    needed.addAll(TrialColumns.RESULT);
    if (table.isEmpty()
        || !table
            .get()
            .require(
                needed,
                "a table of this study's trials, with the columns " + String.join(", ", needed))) {
      return Optional.empty();
    }
    Set<String> practice = new LinkedHashSet<>();
    for (TrialBlock block : design.blocks()) {
      block.practice().ifPresent(criterion -> practice.add(block.name()));
    }
    List<CsvRow> rows = new ArrayList<>();
    boolean known = true;
    for (CsvRow row : table.get().rows()) {
      if (!practice.contains(row.cell("block"))) {
        rows.add(row);
        known &= known(row, design, problems);
      }
    }
    return known ? Optional.of(new StudyTrials(table.get(), rows, source)) : Optional.empty();
  }

  private static boolean known(CsvRow row, StudyDesign design, ProblemCollector problems) {
    if (row.cell("participant").isEmpty()) {
      problems.error(row.location("participant"), "the participant is missing");
      return false;
    }
    for (Factor factor : design.factors()) {
      String level = row.cell(factor.name());
      if (!level.isEmpty() && factor.level(level).isEmpty()) {
        problems.error(
            row.location(factor.name()),
            "'%s' is no level of the study's factor %s; nothing is analysed"
                .formatted(level, factor.name()));
        return false;
      }
    }
    return true;
  }

  /** Returns the trials with these cells. */
  List<CsvRow> rows(Map<String, String> where) {
    return rows.stream()
        .filter(
            row ->
                where.entrySet().stream()
                    .allMatch(
                        cell -> {
                          String found = row.cellIfAny(cell.getKey());
                          return found.equals(cell.getValue())
                              || found.equals(SpreadsheetText.marked(cell.getValue()));
                        }))
        .toList();
  }
}
