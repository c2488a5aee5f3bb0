package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.detection.UnequalVarianceFit.Estimate;
import org.selectiverenderer.statistics.report.ReportBlock.Picture;
import org.selectiverenderer.statistics.report.ReportBlock.Section;
import org.selectiverenderer.statistics.report.ReportBlock.Table;
import org.selectiverenderer.statistics.study.RatingAnalysis;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Builds the section about the confidence ratings of one area: the area under the ROC and the
 * unequal-variance model.
 */
final class RatingSection {
  private static final String POOLED =
      "Ratings of all participants of a condition, taken together (pooled): criteria that differ"
          + " between participants flatten such a ROC, so d_a is below the mean of theirs, and the"
          + " standard errors leave out that answers of one participant belong together. Do not test"
          + " conditions by them.";
  private static final String WORDS =
      "AUC: area under the points. d_a, A_z, slope: two normal distributions with standard deviations"
          + " of their own, fitted by maximum likelihood; a slope below 1 says that the ratings of"
          + " present objects spread more. G²: misfit; p of slope: of a slope other than 1.";

  private final StudyAnalysis study;
  private final RocPlot plot;

  RatingSection(StudyAnalysis study, RocPlot plot) {
    this.study = study;
    this.plot = plot;
  }

  /**
   * Returns the table of pooled ratings, its plots, and the table of each participant as a folded
   * section.
   */
  List<ReportBlock> of(String area) {
    List<ReportBlock> blocks = new ArrayList<>();
    List<RatingAnalysis> pooled = study.ratings(area, true);
    List<String> notes = new ArrayList<>(List.of(WORDS, POOLED));
    if (study.unrated() > 0) {
      notes.add("Answers without a confidence (%d) are no ratings.".formatted(study.unrated()));
    }
    blocks.add(table(area + ": confidence ratings, pooled by condition", "n", pooled, notes));
    for (String type : pooled.stream().map(RatingAnalysis::type).distinct().toList()) {
      blocks.add(
          new Picture(
              "ROC of the pooled ratings of "
                  + type
                  + " objects: points, and the fitted curve where there is one.",
              plot.svg(
                  pooled.stream().filter(score -> score.type().equals(type)).toList(),
                  title(area, type))));
    }
    blocks.add(
        new Section(
            "Details: " + area + ", confidence ratings of each participant",
            true,
            List.of(
                table(
                    area + ": confidence ratings by participant",
                    "participant",
                    study.ratings(area, false),
                    List.of(WORDS)))));
    return blocks;
  }

  static String title(String area, String type) {
    return "%s, ROC, %s objects".formatted(area, type);
  }

  private static Table table(
      String caption, String who, List<RatingAnalysis> scores, List<String> notes) {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (RatingAnalysis score : scores) {
      Optional<String> flaw = score.fit().flaw();
      rows.add(
          List.of(
              score.type(),
              score.condition(),
              score.participant().orElse(String.valueOf(score.participants())),
              score.ratings().signalTotal() + ", " + score.ratings().noiseTotal(),
              withError(
                  score.roc().area(), score.roc().standardError(), score.roc().flaw(), figures),
              withError(score.fit().distance(), flaw, figures),
              withError(score.fit().area(), flaw, figures),
              withError(score.fit().slope(), flaw, figures),
              figures.p(
                  score.fit().slopeP(),
                  flaw.or(() -> Optional.of("a slope of 1 has no finite fit"))),
              flaw.isPresent()
                  ? figures.dash(flaw.get())
                  : "%s (%d)".formatted(figures.number(score.fit().g2(), 2), score.fit().df())));
    }
    List<String> all = new ArrayList<>(figures.notes());
    all.addAll(notes);
    return new Table(
        caption,
        List.of(
            "object type",
            "condition",
            who,
            "present, absent",
            "AUC (SE)",
            "d_a (SE)",
            "A_z (SE)",
            "slope (SE)",
            "p of slope",
            "G² (df)"),
        rows,
        all);
  }

  private static String withError(
      Estimate estimate, Optional<String> flaw, TableNumberFormat figures) {
    return withError(estimate.value(), estimate.standardError(), flaw, figures);
  }

  private static String withError(
      double value, double error, Optional<String> flaw, TableNumberFormat figures) {
    if (!Double.isFinite(value)) {
      return figures.dash(flaw.orElse("not defined for these data"));
    }
    return figures.number(value, 2)
        + " ("
        + figures.number(error, 2, Optional.of("one rating has no standard error"))
        + ")";
  }
}
