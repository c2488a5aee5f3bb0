package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.apa.ApaSentences;
import org.selectiverenderer.statistics.apa.MethodsParagraph;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.report.ReportBlock.Items;
import org.selectiverenderer.statistics.report.ReportBlock.Paragraph;
import org.selectiverenderer.statistics.report.ReportBlock.Picture;
import org.selectiverenderer.statistics.report.ReportBlock.Section;
import org.selectiverenderer.statistics.report.ReportBlock.Table;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Builds the blocks of a study's report: methods, exclusions, and for each area tables, plots and
 * details.
 */
final class StudyReportBuilder {
  static final String TITLE = "Memory recognition: signal detection and analysis of variance";

  private final StudyAnalysis study;
  private final boolean details;
  private final InteractionPlot plot = new InteractionPlot();
  private final RatingSection ratings;

  private StudyReportBuilder(StudyAnalysis study, boolean details) {
    this.study = study;
    this.details = details;
    ratings = new RatingSection(study, new RocPlot());
  }

  /**
   * Returns all blocks of the report.
   *
   * @param details whether to include sections of details, which take the most time to compute
   */
  static List<ReportBlock> of(StudyAnalysis study, Provenance provenance, boolean details) {
    StudyReportBuilder blocks = new StudyReportBuilder(study, details);
    List<ReportBlock> all = new ArrayList<>();
    all.add(provenance.head(study.responses().source()));
    all.add(new Paragraph(blocks.summary()));
    List<String> methods = new ArrayList<>(MethodsNotes.of(study.scoring()));
    methods.addAll(MethodsNotes.of(study.options()));
    methods.add(MethodsNotes.of(study.family()));
    all.add(new Section("Methods", false, List.of(new Items(methods))));
    all.add(new Section("Exclusions and missing data", false, MissingDataSection.of(study)));
    study.areas().forEach(area -> all.add(blocks.area(area)));
    if (details) {
      all.add(blocks.paragraph(provenance));
    }
    return all;
  }

  private String summary() {
    List<String> groups = new ArrayList<>();
    study
        .conditions()
        .forEach(name -> groups.add("%s (%d)".formatted(name, study.participants(name))));
    return "%s in the condition%s %s; %s about %s."
        .formatted(
            Pluralizer.of(study.participants().size(), "participant"),
            groups.size() == 1 ? "" : "s",
            String.join(", ", groups),
            Pluralizer.of(study.responses().usable().size(), "usable answer"),
            String.join(", ", study.areas()));
  }

  /** Returns the methods paragraph for a manuscript. */
  private Section paragraph(Provenance provenance) {
    MethodsParagraph methods = new MethodsParagraph(study, provenance.maker());
    return new Section(
        "Methods and references to paste",
        true,
        List.of(new Paragraph(methods.text()), new Items(methods.references())));
  }

  private Section area(String area) {
    List<AreaAnalysis> analyses = study.analyses(area).toList();
    List<ReportBlock> blocks = new ArrayList<>();
    blocks.add(ScoresTable.of(study, area));
    blocks.add(effects(area, analyses));
    for (AreaAnalysis analysis : analyses) {
      analysis
          .anova()
          .filter(anova -> analysis.level() == ConfidenceThreshold.ALL)
          .ifPresent(anova -> blocks.add(picture(analysis, anova)));
    }
    blocks.addAll(ratings.of(area));
    if (details) {
      blocks.addAll(details(area, analyses));
    }
    return new Section("Area: " + area, false, blocks);
  }

  /** Returns the folded sections of details. */
  private List<ReportBlock> details(String area, List<AreaAnalysis> analyses) {
    List<ReportBlock> blocks = new ArrayList<>();
    blocks.add(
        new Section(
            "Sentences to paste: " + area,
            true,
            Stream.of(ConfidenceThreshold.values())
                .map(level -> (ReportBlock) new Items(ApaSentences.of(study, area, level)))
                .toList()));
    List<ReportBlock> others = new ArrayList<>();
    for (AreaAnalysis analysis : analyses) {
      analysis
          .anova()
          .filter(anova -> analysis.level() != ConfidenceThreshold.ALL)
          .ifPresent(anova -> others.add(picture(analysis, anova)));
    }
    if (!others.isEmpty()) {
      blocks.add(new Section("Plots at the other confidence levels: " + area, true, others));
    }
    for (AreaAnalysis analysis : analyses) {
      blocks.add(new Section("Details: " + title(analysis), true, details(analysis)));
    }
    return blocks;
  }

  private static List<ReportBlock> details(AreaAnalysis analysis) {
    List<ReportBlock> blocks = new ArrayList<>();
    if (!analysis.notes().isEmpty()) {
      blocks.add(new Items(analysis.notes()));
    }
    if (analysis.anova().isPresent() && analysis.evidence().isPresent()) {
      List<EffectBayesFactors> evidence = analysis.evidence().get().withRobustness();
      BayesFactorRobustnessPlot.svg(evidence).ifPresent(svg -> blocks.add(robustness(svg)));
      blocks.addAll(AnovaSection.of(analysis.anova().get(), evidence));
    }
    return blocks;
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

  private static Picture robustness(String svg) {
    return new Picture("How much the Bayes factors depend on the width of their prior.", svg);
  }

  static String title(AreaAnalysis analysis) {
    return "%s, %s, %s"
        .formatted(analysis.area(), analysis.measure().symbol(), analysis.level().title());
  }

  private Table effects(String area, List<AreaAnalysis> analyses) {
    TableNumberFormat figures = new TableNumberFormat();
    boolean corrected = study.family() != MultipleTestingCorrection.NONE;
    List<List<String>> rows = new ArrayList<>();
    for (AreaAnalysis analysis : analyses) {
      String name = analysis.measure().symbol() + " " + analysis.level().heading();
      if (analysis.anova().isEmpty() || analysis.evidence().isEmpty()) {
        String reason = analysis.notes().get(analysis.notes().size() - 1);
        List<String> row = new ArrayList<>();
        row.addAll(List.of(name, "", figures.dash(reason.replaceFirst("\\.$", "")), ""));
        row.addAll(Collections.nCopies(corrected ? 4 : 3, ""));
        row.add(String.valueOf(analysis.design().subjects().size()));
        rows.add(row);
        continue;
      }
      Anova anova = analysis.anova().get();
      List<EffectBayesFactors> evidence = analysis.evidence().get().effects();
      for (int i = 0; i < anova.effects().size(); i++) {
        Effect effect = anova.effects().get(i);
        List<String> row = new ArrayList<>();
        row.addAll(
            List.of(
                name, effect.name(), test(effect, figures), figures.p(effect.p(), effect.flaw())));
        if (corrected) {
          row.add(figures.p(study.adjusted(analysis, effect), effect.flaw()));
        }
        row.add(figures.interval(effect.partialEta(), effect.flaw()));
        row.add(figures.p(effect.equivalence().p(), effect.flaw()));
        row.add(figures.bayes(evidence.get(i).bf01(), effect.flaw()));
        row.add(String.valueOf(analysis.design().subjects().size()));
        rows.add(row);
      }
    }
    List<String> header = new ArrayList<>(List.of("measure", "effect", "F", "p"));
    if (corrected) {
      header.add("p corrected");
    }
    header.addAll(List.of("ηp² [90 % CI]", "p equiv.", "BF01", "n"));
    String caption =
        "%s: effects, equivalence (ηp² < %s), Bayes factors (JZS)"
            .formatted(area, String.format(Locale.ROOT, "%.2f", study.options().etaBound()));
    return new Table(caption, header, rows, notes(analyses, figures));
  }

  /**
   * Returns the footnotes and the notes of the analyses; a note shared by several analyses occurs
   * once.
   */
  private static List<String> notes(List<AreaAnalysis> analyses, TableNumberFormat figures) {
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

  private static String test(Effect effect, TableNumberFormat figures) {
    return Double.isFinite(effect.f())
        ? "F(%s, %s) = %s"
            .formatted(
                figures.df(effect.testDf1()),
                figures.df(effect.testDf2()),
                figures.number(effect.f(), 3))
        : figures.number(effect.f(), 3, effect.flaw());
  }
}
