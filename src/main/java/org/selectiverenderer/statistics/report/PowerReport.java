package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.base.decimal.Counted;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.statistics.report.Block.Paragraph;
import org.selectiverenderer.statistics.report.Block.Table;
import org.selectiverenderer.statistics.simulation.Power;
import org.selectiverenderer.statistics.simulation.PowerAnalysis;
import org.selectiverenderer.statistics.simulation.PowerGoal;

/**
 * A power analysis in its forms.
 *
 * @param power of the number of participants asked for
 * @param wanted for how much power the number of participants was sought
 * @param needed the number found; empty when the most tried is not enough
 */
public record PowerReport(
    PowerAnalysis analysis, Power power, Optional<Wanted> wanted, OptionalInt needed) {
  /**
   * A power to be reached.
   *
   * @param target from 0 to 1
   * @param most participants to be tried
   */
  public record Wanted(PowerGoal goal, double target, int most) {}

  /** Runs the simulations. */
  public static PowerReport of(PowerAnalysis analysis, int participants, Optional<Wanted> wanted) {
    Power power = analysis.power(participants);
    OptionalInt needed =
        wanted.isPresent()
            ? analysis.needed(
                wanted.get().goal().finding(), wanted.get().target(), wanted.get().most())
            : OptionalInt.empty();
    return new PowerReport(analysis, power, wanted, needed);
  }

  /** For a terminal. */
  public String text() {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    for (Power.Finding finding : power.findings()) {
      rows.add(
          List.of(
              finding.name(),
              figures.number(finding.share(), 3),
              "["
                  + figures.number(finding.low(), 3)
                  + ", "
                  + figures.number(finding.high(), 3)
                  + "]"));
    }
    List<Block> blocks = new ArrayList<>();
    blocks.add(
        new Paragraph(
            "%s of %s; %s, %s; seed %d."
                .formatted(
                    power.studies() == 1
                        ? "1 simulated study"
                        : power.studies() + " simulated studies",
                    Counted.of(power.participants(), "participant"),
                    analysis.area(),
                    analysis.measure().symbol(),
                    analysis.seed())));
    blocks.add(
        new Table(
            "Share of studies that find it", List.of("", "power", "95 % CI"), rows, List.of()));
    wanted.ifPresent(goal -> blocks.add(new Paragraph(sentence(goal))));
    return TextPage.of("Power by simulation", blocks, true);
  }

  private String sentence(Wanted goal) {
    String percent = String.format(Locale.ROOT, "%.0f %%", 100 * goal.target());
    return needed.isPresent()
        ? "For a power of %s for %s it takes %s."
            .formatted(percent, goal.goal().finding(), Counted.of(needed.getAsInt(), "participant"))
        : "%s are not enough for a power of %s for %s."
            .formatted(Counted.of(goal.most(), "participant"), percent, goal.goal().finding());
  }

  /** For programs. */
  public String json() {
    ObjectNode json = JsonTree.object();
    json.put("participants", power.participants()).put("studies", power.studies());
    json.put("seed", analysis.seed()).put("area", analysis.area());
    json.put("measure", analysis.measure().key());
    ArrayNode findings = json.putArray("power");
    for (Power.Finding finding : power.findings()) {
      ObjectNode node = findings.addObject().put("finding", finding.name());
      JsonNumbers.put(node, "power", finding.share());
      JsonNumbers.put(node, "low", finding.low());
      JsonNumbers.put(node, "high", finding.high());
    }
    if (wanted.isPresent()) {
      ObjectNode node = json.putObject("needed");
      node.put("finding", wanted.get().goal().finding());
      JsonNumbers.put(node, "target", wanted.get().target());
      if (needed.isPresent()) {
        node.put("participants", needed.getAsInt());
      } else {
        node.putNull("participants").put("tried", wanted.get().most());
      }
    }
    return JsonText.of(json);
  }
}
