package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.decimal.Counted;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.data.Exclusion;
import org.selectiverenderer.statistics.detection.ConfidenceLevel;
import org.selectiverenderer.statistics.report.Block.Items;
import org.selectiverenderer.statistics.report.Block.Paragraph;
import org.selectiverenderer.statistics.report.Block.Picture;
import org.selectiverenderer.statistics.report.Block.Section;
import org.selectiverenderer.statistics.report.Block.Table;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/** A study's report: methods, exclusions, and for each area tables, plots and details. */
final class StudyBlocks {
  static final String TITLE = "Memory recognition: signal detection and analysis of variance";

  private final StudyAnalysis study;
  private final MeansPlot plot = new MeansPlot();

  private StudyBlocks(StudyAnalysis study) {
    this.study = study;
  }

  static List<Block> of(StudyAnalysis study) {
    StudyBlocks blocks = new StudyBlocks(study);
    List<Block> all = new ArrayList<>();
    all.add(new Paragraph(blocks.summary()));
    List<String> methods = new ArrayList<>(Methods.of(study.scoring()));
    methods.addAll(Methods.of(study.options()));
    all.add(new Section("Methods", false, List.of(new Items(methods))));
    all.add(new Section("Exclusions and missing data", false, List.of(blocks.exclusions())));
    study.areas().forEach(area -> all.add(blocks.area(area)));
    return all;
  }

  private String summary() {
    List<String> groups = new ArrayList<>();
    study
        .conditions()
        .forEach(name -> groups.add("%s (%d)".formatted(name, study.participants(name))));
    return "%s in the condition%s %s; %s about %s. Source: %s."
        .formatted(
            Counted.of(study.participants().size(), "participant"),
            groups.size() == 1 ? "" : "s",
            String.join(", ", groups),
            Counted.of(study.responses().usable().size(), "usable answer"),
            String.join(", ", study.areas()),
            study.responses().source().name());
  }

  private Block exclusions() {
    List<Exclusion> exclusions = study.responses().exclusions();
    return exclusions.isEmpty()
        ? new Paragraph("None. Every answer of the file is used.")
        : AnovaReport.exclusions(exclusions);
  }

  private Section area(String area) {
    List<AreaAnalysis> analyses = study.analyses(area).toList();
    List<Block> blocks = new ArrayList<>();
    blocks.add(ScoresTable.of(study, area));
    blocks.add(effects(area, analyses));
    for (AreaAnalysis analysis : analyses) {
      analysis
          .anova()
          .filter(anova -> analysis.level() == ConfidenceLevel.ALL)
          .ifPresent(anova -> blocks.add(picture(analysis, anova)));
    }
    List<Block> others = new ArrayList<>();
    for (AreaAnalysis analysis : analyses) {
      analysis
          .anova()
          .filter(anova -> analysis.level() != ConfidenceLevel.ALL)
          .ifPresent(anova -> others.add(picture(analysis, anova)));
    }
    if (!others.isEmpty()) {
      blocks.add(new Section("Plots at the other confidence levels: " + area, true, others));
    }
    for (AreaAnalysis analysis : analyses) {
      List<Block> details = new ArrayList<>();
      if (!analysis.notes().isEmpty()) {
        details.add(new Items(analysis.notes()));
      }
      analysis.anova().ifPresent(anova -> details.addAll(AnovaBlocks.of(anova)));
      blocks.add(new Section("Details: " + title(analysis), true, details));
    }
    return new Section("Area: " + area, false, blocks);
  }

  private Picture picture(AreaAnalysis analysis, Anova anova) {
    return new Picture(
        "%s (%s): estimated marginal means with 95 %% intervals (pooled error), and each participant (n = %d)."
            .formatted(
                analysis.measure().symbol(),
                analysis.measure().meaning(),
                anova.design().subjects().size()),
        plot.svg(anova, title(analysis)));
  }

  private static String title(AreaAnalysis analysis) {
    return "%s, %s, %s"
        .formatted(
            analysis.area(),
            analysis.measure().symbol(),
            analysis.level() == ConfidenceLevel.ALL
                ? "all answers"
                : "confidence " + analysis.level().spelling());
  }

  private Table effects(String area, List<AreaAnalysis> analyses) {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    for (AreaAnalysis analysis : analyses) {
      String name = analysis.measure().symbol() + " " + analysis.level().heading();
      if (analysis.anova().isEmpty()) {
        String reason = analysis.notes().get(analysis.notes().size() - 1);
        rows.add(
            List.of(
                name,
                "",
                figures.dash(reason.replaceFirst("\\.$", "")),
                "",
                "",
                "",
                "",
                String.valueOf(analysis.design().subjects().size())));
        continue;
      }
      for (Effect effect : analysis.anova().get().effects()) {
        rows.add(
            List.of(
                name,
                effect.name(),
                test(effect, figures),
                figures.p(effect.p(), effect.flaw()),
                figures.interval(effect.partialEta(), effect.flaw()),
                figures.p(effect.equivalence().p(), effect.flaw()),
                figures.bayes(effect.bayesFactor(), effect.flaw()),
                String.valueOf(analysis.design().subjects().size())));
      }
    }
    return new Table(
        area + ": effects",
        List.of(
            "measure",
            "effect",
            "F",
            "p",
            "ηp² [90 % CI]",
            "p (ηp² < %s)"
                .formatted(String.format(Locale.ROOT, "%.2f", study.options().etaBound())),
            "BF01 (BIC)",
            "n"),
        rows,
        notes(analyses, figures));
  }

  /** Footnotes, and once for each level what is true of its analyses. */
  private static List<String> notes(List<AreaAnalysis> analyses, TableFigures figures) {
    Map<String, Set<String>> levels = new LinkedHashMap<>();
    for (AreaAnalysis analysis : analyses) {
      for (String note : analysis.notes()) {
        levels
            .computeIfAbsent(note, first -> new LinkedHashSet<>())
            .add(analysis.level().heading());
      }
    }
    List<String> notes = new ArrayList<>(figures.notes());
    levels.forEach((note, where) -> notes.add(String.join(", ", where) + ": " + note));
    return notes;
  }

  private static String test(Effect effect, TableFigures figures) {
    return Double.isFinite(effect.f())
        ? "F(%s, %s) = %s"
            .formatted(
                figures.df(effect.df1()), figures.df(effect.df2()), figures.number(effect.f(), 3))
        : figures.number(effect.f(), 3, effect.flaw());
  }
}
