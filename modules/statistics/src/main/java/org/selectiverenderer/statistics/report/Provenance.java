package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.LocalDate;
import java.util.LinkedHashMap;
import java.util.Map;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.report.ReportBlock.Paragraph;

/**
 * The program, version and date of a report. Its data are identified by a {@link DataSource}.
 *
 * @param program name of the program
 * @param version version of the program
 * @param date date of the report
 * @param dated whether machine-readable reports state the date too. By default they do not, so that
 *     the same input gives the same bytes; reports for people always do
 */
public record Provenance(String program, String version, LocalDate date, boolean dated) {
  /** Returns the program's name with its version. */
  String maker() {
    return program + " " + version;
  }

  /** Returns the first paragraph of a report. */
  Paragraph head(DataSource source) {
    return new Paragraph(
        "Made by %s on %s from %s%s."
            .formatted(
                maker(),
                date,
                source.name(),
                source.sha256().map(sum -> ", SHA-256 " + sum).orElse("")));
  }

  /** Returns the columns and cells with the provenance that every row of a CSV table has. */
  Map<String, String> cells(DataSource source) {
    Map<String, String> cells = new LinkedHashMap<>();
    cells.put("program", maker());
    cells.put("source", source.name());
    cells.put("source_sha256", source.sha256().orElse(""));
    if (dated) {
      cells.put("date", date.toString());
    }
    return cells;
  }

  /** Writes the keys {@code source} and {@code made_by}. */
  void write(DataSource source, ObjectNode json) {
    json.put("source", source.name());
    source.sha256().ifPresent(sum -> json.put("source_sha256", sum));
    ObjectNode by = JsonTree.object().put("program", program).put("version", version);
    if (dated) {
      by.put("date", date.toString());
    }
    json.set("made_by", by);
  }
}
