package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.bayes.EffectEvidence;
import org.selectiverenderer.statistics.data.DataFile;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.report.Block.Items;
import org.selectiverenderer.statistics.report.Block.Picture;
import org.selectiverenderer.statistics.report.Block.Section;
import org.selectiverenderer.statistics.report.Block.Table;

/** Writes the report of one analysis of variance as text, HTML and JSON. */
public final class AnovaReport {
  private AnovaReport() {}

  /** Returns the report as plain text for a terminal. */
  public static String text(
      Anova anova, List<Exclusion> exclusions, DataFile source, Provenance provenance) {
    List<Block> blocks = new ArrayList<>(List.of(provenance.head(source)));
    blocks.addAll(blocks(anova, new BayesianAnova(anova).withRobustness(), exclusions));
    return TextPage.of(title(anova), blocks, true);
  }

  /** Returns the report as one self-contained HTML page. */
  public static String html(
      Anova anova, List<Exclusion> exclusions, DataFile source, Provenance provenance) {
    List<Block> blocks = new ArrayList<>(List.of(provenance.head(source)));
    blocks.add(
        new Picture(
            "Estimated marginal means with 95 % intervals (pooled error), and each participant.",
            new MeansPlot().svg(anova, anova.design().measure())));
    List<EffectEvidence> evidence = new BayesianAnova(anova).withRobustness();
    RobustnessPlot.svg(evidence)
        .ifPresent(
            svg ->
                blocks.add(
                    new Picture(
                        "How much the Bayes factors depend on the width of their prior.", svg)));
    blocks.addAll(blocks(anova, evidence, exclusions));
    return HtmlPage.of(title(anova), blocks);
  }

  /** Returns the report as JSON. */
  public static String json(
      Anova anova, List<Exclusion> exclusions, DataFile source, Provenance provenance) {
    ObjectNode json = JsonTree.object();
    AnovaJson.write(anova, new BayesianAnova(anova), json);
    provenance.write(source, json);
    AnovaJson.options(anova.options(), json.putObject("options"));
    AnovaJson.exclusions(exclusions, json);
    return JsonText.of(json);
  }

  private static String title(Anova anova) {
    return "Analysis of variance of " + anova.design().measure();
  }

  private static List<Block> blocks(
      Anova anova, List<EffectEvidence> evidence, List<Exclusion> exclusions) {
    List<Block> blocks = new ArrayList<>(AnovaBlocks.of(anova, evidence));
    blocks.add(new Section("Methods", false, List.of(new Items(Methods.of(anova.options())))));
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
