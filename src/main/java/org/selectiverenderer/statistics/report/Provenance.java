package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.LocalDate;
import java.util.LinkedHashMap;
import java.util.Map;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.statistics.data.DataFile;
import org.selectiverenderer.statistics.report.Block.Paragraph;

/**
 * Who made a report, and when; of what is told by its {@link DataFile}.
 *
 * @param program its name
 * @param version of the program
 * @param date of the report
 * @param dated whether reports for programs state the date too. As a rule they do not, so that the
 *     same input gives the same bytes; those for people always do
 */
public record Provenance(String program, String version, LocalDate date, boolean dated) {
  /** The program with its version. */
  String maker() {
    return program + " " + version;
  }

  /** The head of a report. */
  Paragraph head(DataFile source) {
    return new Paragraph(
        "Made by %s on %s from %s%s."
            .formatted(
                maker(),
                date,
                source.name(),
                source.sha256().map(sum -> ", SHA-256 " + sum).orElse("")));
  }

  /** Columns that every row of a table for programs has, with their cells. */
  Map<String, String> cells(DataFile source) {
    Map<String, String> cells = new LinkedHashMap<>();
    cells.put("program", maker());
    cells.put("source", source.name());
    cells.put("source_sha256", source.sha256().orElse(""));
    if (dated) {
      cells.put("date", date.toString());
    }
    return cells;
  }

  /** The keys {@code source} and {@code made_by}. */
  void write(DataFile source, ObjectNode json) {
    json.put("source", source.name());
    source.sha256().ifPresent(sum -> json.put("source_sha256", sum));
    ObjectNode by = JsonTree.object().put("program", program).put("version", version);
    if (dated) {
      by.put("date", date.toString());
    }
    json.set("made_by", by);
  }
}
