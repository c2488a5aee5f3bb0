package org.selectiverenderer.statistics.apa;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.statistics.anova.CellDescriptives;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.PairwiseComparison;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;
import org.selectiverenderer.statistics.study.RatingAnalysis;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/** Builds the APA tables of one area. */
public final class ApaTableBuilder {
  private final StudyAnalysis study;
  private final String area;

  private ApaTableBuilder(StudyAnalysis study, String area) {
    this.study = study;
    this.area = area;
  }

  /** Returns the tables of means, effects, comparisons and ratings. */
  public static List<ApaTable> of(StudyAnalysis study, String area) {
    ApaTableBuilder tables = new ApaTableBuilder(study, area);
    return List.of(tables.means(), tables.effects(), tables.comparisons(), tables.ratings());
  }

  private record Cell(ConfidenceThreshold level, String type, String condition, int n) {}

  /**
   * Returns the table of means. Measures stand in one row where they have the same number of
   * participants, which is the normal case.
   */
  private ApaTable means() {
    Map<Cell, Map<DetectionMeasure, CellDescriptives>> cells = new LinkedHashMap<>();
    study
        .analyses(area)
        .forEach(
            analysis -> {
              for (CellDescriptives found : CellDescriptives.of(analysis.design())) {
                if (found.n() > 0) {
                  Cell cell =
                      new Cell(
                          analysis.level(),
                          found.within().orElse(analysis.design().within().levels().get(0)),
                          found.between().orElse("all"),
                          found.n());
                  cells
                      .computeIfAbsent(cell, first -> new LinkedHashMap<>())
                      .put(analysis.measure(), found);
                }
              }
            });
    List<String> header = new ArrayList<>(List.of("Answers", "Object type", "Condition", "n"));
    for (DetectionMeasure measure : DetectionMeasure.values()) {
      header.add(measure.symbol() + ": M");
      header.add(measure.symbol() + ": SD");
    }
    List<List<String>> rows = new ArrayList<>();
    cells.forEach(
        (cell, measures) -> {
          List<String> row =
              new ArrayList<>(
                  List.of(
                      cell.level().title(),
                      cell.type(),
                      cell.condition(),
                      String.valueOf(cell.n())));
          for (DetectionMeasure measure : DetectionMeasure.values()) {
            CellDescriptives found = measures.get(measure);
            row.add(found == null ? ApaNumberFormat.NONE : ApaNumberFormat.of(found.mean(), 2));
            row.add(found == null ? ApaNumberFormat.NONE : ApaNumberFormat.of(found.sd(), 2));
          }
          rows.add(row);
        });
    return new ApaTable(
        "means",
        "Sensitivity and Bias by Object Type and Condition: " + area,
        header,
        3,
        rows,
        "Positive log β and c: a bias towards “no”.");
  }

  private ApaTable effects() {
    boolean corrected = study.family() != MultipleTestingCorrection.NONE;
    List<String> header =
        new ArrayList<>(List.of("Answers", "Measure", "Effect", "n", "df", "F", "p"));
    if (corrected) {
      header.add("p corrected");
    }
    header.addAll(List.of("ηp²", "90% CI", "p of equivalence", "BF01"));
    List<List<String>> rows = new ArrayList<>();
    study
        .analyses(area)
        .forEach(
            analysis ->
                analysis
                    .anova()
                    .ifPresent(
                        anova ->
                            analysis
                                .evidence()
                                .map(BayesianAnova::effects)
                                .orElse(List.of())
                                .forEach(
                                    evidence ->
                                        rows.add(
                                            row(
                                                analysis,
                                                evidence.of(anova),
                                                evidence,
                                                corrected)))));
    return new ApaTable(
        "effects",
        "Analyses of Variance: " + area,
        header,
        3,
        rows,
        "Equivalence: ηp² < %s.%s"
            .formatted(
                ApaNumberFormat.share(study.options().etaBound(), 2),
                corrected ? " Corrected over the study: " + study.family().title() + "." : ""));
  }

  private List<String> row(
      AreaAnalysis analysis, Effect effect, EffectBayesFactors evidence, boolean corrected) {
    List<String> row = new ArrayList<>();
    row.add(analysis.level().title());
    row.add(analysis.measure().symbol());
    row.add(effect.name().replace(" x ", " × "));
    row.add(String.valueOf(analysis.design().subjects().size()));
    row.add(ApaNumberFormat.df(effect.testDf1()) + ", " + ApaNumberFormat.df(effect.testDf2()));
    row.add(ApaNumberFormat.of(effect.f(), 2));
    row.add(ApaNumberFormat.p(effect.p()));
    if (corrected) {
      row.add(ApaNumberFormat.p(study.adjusted(analysis, effect)));
    }
    row.add(ApaNumberFormat.share(effect.partialEta().value(), 2));
    row.add(ApaNumberFormat.interval(effect.partialEta().low(), effect.partialEta().high(), 2));
    row.add(ApaNumberFormat.p(effect.equivalence().p()));
    row.add(ApaNumberFormat.bayes(evidence.bf01()));
    return row;
  }

  private ApaTable comparisons() {
    List<List<String>> rows = new ArrayList<>();
    study
        .analyses(area)
        .filter(analysis -> analysis.level() == ConfidenceThreshold.ALL)
        .forEach(
            analysis ->
                analysis
                    .anova()
                    .ifPresent(
                        anova ->
                            anova.comparisons().forEach(pair -> rows.add(row(analysis, pair)))));
    return new ApaTable(
        "comparisons",
        "Comparisons, All Answers: " + area,
        List.of(
            "Measure",
            "Comparison",
            "At",
            "n",
            "Difference",
            "95% CI",
            "t",
            "df",
            "p",
            "p (Holm)",
            "d"),
        3,
        rows,
        "n: participants of the analysis. Holm: within the comparisons of a factor at a level.");
  }

  private static List<String> row(AreaAnalysis analysis, PairwiseComparison pair) {
    return List.of(
        analysis.measure().symbol(),
        pair.first() + " − " + pair.second(),
        pair.at().orElse(pair.factor().contains(" x ") ? "differences" : "all"),
        String.valueOf(analysis.design().subjects().size()),
        ApaNumberFormat.of(pair.difference(), 2),
        "[" + ApaNumberFormat.of(pair.low(), 2) + ", " + ApaNumberFormat.of(pair.high(), 2) + "]",
        ApaNumberFormat.of(pair.t(), 2),
        ApaNumberFormat.df(pair.df()),
        ApaNumberFormat.p(pair.p()),
        ApaNumberFormat.p(pair.holm()),
        ApaNumberFormat.of(pair.d().value(), 2));
  }

  private ApaTable ratings() {
    List<List<String>> rows = new ArrayList<>();
    for (RatingAnalysis score : study.ratings(area, true)) {
      rows.add(
          List.of(
              score.type(),
              score.condition(),
              String.valueOf(score.participants()),
              score.ratings().signalTotal() + ", " + score.ratings().noiseTotal(),
              withError(score.roc().area(), score.roc().standardError(), true),
              withError(
                  score.fit().distance().value(), score.fit().distance().standardError(), false),
              withError(score.fit().area().value(), score.fit().area().standardError(), true),
              withError(score.fit().slope().value(), score.fit().slope().standardError(), false),
              Double.isFinite(score.fit().g2())
                  ? "%s (%d)".formatted(ApaNumberFormat.of(score.fit().g2(), 2), score.fit().df())
                  : ApaNumberFormat.NONE,
              ApaNumberFormat.p(score.fit().fitP())));
    }
    return new ApaTable(
        "ratings",
        "Pooled Confidence Ratings: " + area,
        List.of(
            "Object type",
            "Condition",
            "n",
            "Ratings of present, absent",
            "AUC (SE)",
            "d_a (SE)",
            "A_z (SE)",
            "Slope (SE)",
            "G² (df)",
            "p"),
        2,
        rows,
        "Ratings of all participants of a condition taken together; standard errors leave out that"
            + " answers of one participant belong together.");
  }

  private static String withError(double value, double error, boolean share) {
    if (!Double.isFinite(value)) {
      return ApaNumberFormat.NONE;
    }
    return share
        ? ApaNumberFormat.share(value, 2) + " (" + ApaNumberFormat.share(error, 2) + ")"
        : ApaNumberFormat.of(value, 2) + " (" + ApaNumberFormat.of(error, 2) + ")";
  }
}
