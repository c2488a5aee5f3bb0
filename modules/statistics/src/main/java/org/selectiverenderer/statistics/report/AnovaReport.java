package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.report.ReportBlock.Items;
import org.selectiverenderer.statistics.report.ReportBlock.Picture;
import org.selectiverenderer.statistics.report.ReportBlock.Section;
import org.selectiverenderer.statistics.report.ReportBlock.Table;

/** Writes the report of one analysis of variance as text, HTML and JSON. */
public final class AnovaReport {
  private AnovaReport() {}

  /** Returns the report as plain text for a terminal. */
  public static String text(
      Anova anova, List<Exclusion> exclusions, DataSource source, Provenance provenance) {
    List<ReportBlock> blocks = new ArrayList<>(List.of(provenance.head(source)));
    blocks.addAll(blocks(anova, new BayesianAnova(anova).withRobustness(), exclusions));
    return TextReportWriter.of(title(anova), blocks, true);
  }

  /** Returns the report as one self-contained HTML page. */
  public static String html(
      Anova anova, List<Exclusion> exclusions, DataSource source, Provenance provenance) {
    List<ReportBlock> blocks = new ArrayList<>(List.of(provenance.head(source)));
    blocks.add(
        new Picture(
            "Estimated marginal means with 95 % intervals (pooled error), and each participant.",
            new InteractionPlot().svg(anova, anova.design().measure())));
    List<EffectBayesFactors> evidence = new BayesianAnova(anova).withRobustness();
    BayesFactorRobustnessPlot.svg(evidence)
        .ifPresent(
            svg ->
                blocks.add(
                    new Picture(
                        "How much the Bayes factors depend on the width of their prior.", svg)));
    blocks.addAll(blocks(anova, evidence, exclusions));
    return HtmlReportWriter.of(title(anova), blocks);
  }

  /** Returns the report as JSON. */
  public static String json(
      Anova anova, List<Exclusion> exclusions, DataSource source, Provenance provenance) {
    ObjectNode json = JsonTree.object();
    AnovaJsonWriter.write(anova, new BayesianAnova(anova), json);
    provenance.write(source, json);
    AnovaJsonWriter.options(anova.options(), json.putObject("options"));
    AnovaJsonWriter.exclusions(exclusions, json);
    return JsonWriter.of(json);
  }

  private static String title(Anova anova) {
    return "Analysis of variance of " + anova.design().measure();
  }

  private static List<ReportBlock> blocks(
      Anova anova, List<EffectBayesFactors> evidence, List<Exclusion> exclusions) {
    List<ReportBlock> blocks = new ArrayList<>(AnovaSection.of(anova, evidence));
    blocks.add(new Section("Methods", false, List.of(new Items(MethodsNotes.of(anova.options())))));
    if (!exclusions.isEmpty()) {
      blocks.add(exclusions(exclusions));
    }
    return blocks;
  }

  static Table exclusions(List<Exclusion> exclusions) {
    return new Table(
        "Data that are missing or left out",
        List.of("place", "participant", "what"),
        exclusions.stream()
            .map(
                exclusion ->
                    List.of(
                        exclusion.location().toString(),
                        exclusion.participant(),
                        exclusion.reason()))
            .toList(),
        List.of());
  }
}
