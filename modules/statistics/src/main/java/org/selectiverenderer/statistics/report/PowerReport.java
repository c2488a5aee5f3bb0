package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.statistics.report.ReportBlock.Paragraph;
import org.selectiverenderer.statistics.report.ReportBlock.Table;
import org.selectiverenderer.statistics.simulation.AnalyticPower;
import org.selectiverenderer.statistics.simulation.PowerAnalysis;
import org.selectiverenderer.statistics.simulation.PowerEstimate;
import org.selectiverenderer.statistics.simulation.TestedHypothesis;

/**
 * The report of a power analysis, as text and JSON.
 *
 * @param power power with the requested number of participants
 * @param formula power by the noncentral F distribution, by name of the finding, where there is a
 *     formula
 * @param wanted the target power for which the number of participants was sought
 * @param needed the number of participants found; empty when the largest number tried is not enough
 */
public record PowerReport(
    PowerAnalysis analysis,
    PowerEstimate power,
    Map<String, Double> formula,
    Optional<Wanted> wanted,
    Optional<PowerAnalysis.Needed> needed) {
  private static final String NO_FORMULA = "by simulation only";

  /**
   * A target power.
   *
   * @param target power to reach, 0 to 1
   * @param most largest number of participants to try
   */
  public record Wanted(TestedHypothesis goal, double target, int most) {}

  /**
   * Runs the simulations.
   *
   * @param participants number of participants, greater than that of conditions
   * @param wanted the target power for which the number of participants is sought
   */
  public static PowerReport of(PowerAnalysis analysis, int participants, Optional<Wanted> wanted) {
    return new PowerReport(
        analysis,
        analysis.power(participants),
        AnalyticPower.of(analysis, participants),
        wanted,
        wanted.flatMap(goal -> analysis.needed(goal.goal().finding(), goal.target(), goal.most())));
  }

  /** Returns the report as plain text for a terminal. */
  public String text() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (PowerEstimate.Finding finding : power.findings()) {
      rows.add(
          List.of(
              finding.name(),
              figures.number(finding.share(), 3),
              "["
                  + figures.number(finding.low(), 3)
                  + ", "
                  + figures.number(finding.high(), 3)
                  + "]",
              formula.containsKey(finding.name())
                  ? figures.number(formula.get(finding.name()), 3)
                  : figures.dash(NO_FORMULA)));
    }
    List<ReportBlock> blocks = new ArrayList<>();
    blocks.add(
        new Paragraph(
            "%s of %s; %s, %s; seed %d."
                .formatted(
                    studies(),
                    Pluralizer.of(power.participants(), "participant"),
                    analysis.area(),
                    analysis.measure().symbol(),
                    analysis.seed())));
    blocks.add(
        new Table(
            "Power: share of simulated studies with this result",
            List.of("", "power", "95 % CI", "by formula"),
            rows,
            figures.notes()));
    wanted.ifPresent(goal -> blocks.add(new Paragraph(sentence(goal))));
    return TextReportWriter.of("Power by simulation", blocks, true);
  }

  private String sentence(Wanted goal) {
    String percent = String.format(Locale.ROOT, "%.0f %%", 100 * goal.target());
    if (needed.isEmpty()) {
      return "%s are not enough for a power of %s for %s."
          .formatted(Pluralizer.of(goal.most(), "participant"), percent, goal.goal().finding());
    }
    PowerAnalysis.Needed found = needed.get();
    return "A power of %s for %s needs %s (%s, by the 95 %% intervals of %s of each size)."
        .formatted(
            percent,
            goal.goal().finding(),
            Pluralizer.of(found.participants(), "participant"),
            found.high().isPresent()
                ? "between %d and %d".formatted(found.low(), found.high().getAsInt())
                : "at least %d, perhaps more than %d".formatted(found.low(), goal.most()),
            studies());
  }

  private String studies() {
    return power.studies() == 1 ? "1 simulated study" : power.studies() + " simulated studies";
  }

  /** Returns the report as JSON. */
  public String json() {
    ObjectNode json = JsonTree.object();
    json.put("participants", power.participants()).put("studies", power.studies());
    json.put("seed", analysis.seed()).put("area", analysis.area());
    json.put("measure", analysis.measure().key());
    ArrayNode findings = json.putArray("power");
    for (PowerEstimate.Finding finding : power.findings()) {
      ObjectNode node = findings.addObject().put("finding", finding.name());
      JsonNumbers.put(node, "power", finding.share());
      JsonNumbers.put(node, "low", finding.low());
      JsonNumbers.put(node, "high", finding.high());
      JsonNumbers.put(node, "formula", formula.getOrDefault(finding.name(), Double.NaN));
    }
    if (wanted.isPresent()) {
      ObjectNode node = json.putObject("needed");
      node.put("finding", wanted.get().goal().finding());
      JsonNumbers.put(node, "target", wanted.get().target());
      if (needed.isPresent()) {
        PowerAnalysis.Needed found = needed.get();
        node.put("participants", found.participants()).put("low", found.low());
        found.high().ifPresentOrElse(high -> node.put("high", high), () -> node.putNull("high"));
      } else {
        node.putNull("participants").put("tried", wanted.get().most());
      }
    }
    return JsonWriter.of(json);
  }
}
