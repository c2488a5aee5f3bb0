package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.statistics.report.ReportBlock.Items;
import org.selectiverenderer.statistics.report.ReportBlock.Paragraph;
import org.selectiverenderer.statistics.report.ReportBlock.Table;
import org.selectiverenderer.statistics.simulation.PowerEstimate;

/**
 * Writes the simulated power of the analyses that a study plans.
 *
 * @param study name of the study
 * @param participants number of participants of each simulated study
 * @param effects the simulated effects, as they were typed
 */
public record PlannedPowerReport(
    String study, int participants, int studies, long seed, List<String> effects, List<Row> rows) {
  /**
   * An effect of an analysis.
   *
   * @param untested number of studies in which it could not be tested
   */
  public record Row(String analysis, PowerEstimate.Finding finding, int untested) {}

  /** Copies the rows. */
  public PlannedPowerReport {
    effects = List.copyOf(effects);
    rows = List.copyOf(rows);
  }

  /** Returns the report as plain text. */
  public String text() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> cells = new ArrayList<>();
    List<String> notes = new ArrayList<>();
    for (Row row : rows) {
      PowerEstimate.Finding finding = row.finding();
      cells.add(
          List.of(
              row.analysis(),
              finding.name(),
              figures.interval(
                  finding.share(), finding.low(), finding.high(), 3, Optional.empty())));
      if (row.untested() > 0) {
        notes.add(
            "%s, %s: not tested in %s, which count as not found."
                .formatted(row.analysis(), finding.name(), studies(row.untested(), "study")));
      }
    }
    return TextReportWriter.of(
        "Power of the analyses of " + study,
        List.of(
            new Paragraph(
                "%s with %s each, seed %d."
                    .formatted(
                        studies(studies, "simulated study"),
                        Pluralizer.of(participants, "participant"),
                        seed)),
            new Items(
                effects.isEmpty()
                    ? List.of("No effect is simulated: the shares below are those of errors.")
                    : effects),
            new Table(
                "Share of studies that find an effect, with its 95 % interval",
                List.of("analysis", "effect", "power"), cells, notes)),
        true);
  }

  private static String studies(int number, String one) {
    return number == 1 ? "1 " + one : number + " " + one.replace("study", "studies");
  }

  /** Returns the report as JSON. */
  public String json() {
    ObjectNode json = JsonTree.object().put("study", study);
    json.put("participants", participants).put("studies", studies).put("seed", seed);
    effects.forEach(json.putArray("effects")::add);
    ArrayNode power = json.putArray("power");
    for (Row row : rows) {
      ObjectNode node = power.addObject().put("analysis", row.analysis());
      node.put("effect", row.finding().name());
      JsonNumbers.put(node, "power", row.finding().share());
      JsonNumbers.put(node, "low", row.finding().low());
      JsonNumbers.put(node, "high", row.finding().high());
      node.put("untested", row.untested());
    }
    return JsonWriter.of(json);
  }
}
