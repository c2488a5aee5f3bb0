package org.selectiverenderer.doctor.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;

/**
 * The report of all results about a machine.
 *
 * @param version version of the program
 * @param lines results in their order
 */
public record DoctorReport(String version, List<Diagnosis> lines) {
  /** Returns whether the program can work: nothing that every user needs is missing. */
  public boolean healthy() {
    return lines.stream().noneMatch(Diagnosis::fatal);
  }

  /** Returns one line per result, in columns; what to do follows after an arrow. */
  public String text() {
    int width = lines.stream().mapToInt(line -> line.subject().length()).max().orElse(0);
    StringBuilder text = new StringBuilder();
    for (Diagnosis line : lines) {
      text.append(pad(line.status().word(), Diagnosis.Status.WARNING.word().length()))
          .append("  ")
          .append(pad(line.subject(), width))
          .append("  ")
          .append(ControlCharacterEscaper.line(line.found()));
      if (!line.todo().isEmpty()) {
        text.append(" -> ").append(ControlCharacterEscaper.line(line.todo()));
      }
      text.append('\n');
    }
    return text.toString();
  }

  /** Returns the report as JSON by {@code doctor.schema.json}. */
  public String json() {
    ObjectNode root = JsonTree.object();
    root.put("version", version);
    ArrayNode checks = root.putArray("checks");
    lines.forEach(line -> checks.add(line.json()));
    ObjectNode summary = root.putObject("summary");
    for (Diagnosis.Status status : Diagnosis.Status.values()) {
      summary.put(status.word(), count(status));
    }
    summary.put("healthy", healthy());
    return JsonWriter.of(root);
  }

  /** Returns the summary in one line. */
  public String summary() {
    return "%d ok, %d warning, %d missing; %s"
        .formatted(
            count(Diagnosis.Status.OK),
            count(Diagnosis.Status.WARNING),
            count(Diagnosis.Status.MISSING),
            healthy()
                ? "nothing is missing that everybody needs"
                : "needed by everybody: "
                    + String.join(
                        ", ",
                        lines.stream()
                            .filter(Diagnosis::fatal)
                            .map(Diagnosis::subject)
                            .distinct()
                            .toList()));
  }

  private long count(Diagnosis.Status status) {
    return lines.stream().filter(line -> line.status() == status).count();
  }

  private static String pad(String text, int width) {
    return text + " ".repeat(Math.max(0, width - text.length()));
  }
}
