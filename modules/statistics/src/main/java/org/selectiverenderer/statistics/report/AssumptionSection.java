package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.assumption.AssumptionChecks;
import org.selectiverenderer.statistics.assumption.LeveneTest;
import org.selectiverenderer.statistics.assumption.Outlier;
import org.selectiverenderer.statistics.assumption.ShapiroWilkTest;
import org.selectiverenderer.statistics.report.ReportBlock.Items;
import org.selectiverenderer.statistics.report.ReportBlock.Table;

/** Builds the table of assumption checks and the sentences about their consequences. */
final class AssumptionSection {
  private static final Optional<String> CONSTANT =
      Optional.of("the distances from the medians do not vary");

  private AssumptionSection() {}

  static List<ReportBlock> of(AssumptionChecks found) {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (LeveneTest test : found.levene()) {
      rows.add(
          List.of(
              "equal variances (Levene, median)" + at(test.at()),
              "F(%s, %s) = %s"
                  .formatted(
                      figures.df(test.df1()),
                      figures.df(test.df2()),
                      figures.number(test.f(), 3, CONSTANT)),
              figures.p(test.p(), CONSTANT)));
    }
    found
        .box()
        .ifPresent(
            test ->
                rows.add(
                    List.of(
                        "equal covariances (Box's M)",
                        "χ²(%s) = %s"
                            .formatted(figures.df(test.df()), figures.number(test.chiSquared(), 3)),
                        figures.p(test.p(), Optional.empty()))));
    for (ShapiroWilkTest test : found.shapiro()) {
      rows.add(
          List.of(
              "normal residuals (Shapiro-Wilk)" + at(test.at()),
              "W = " + figures.number(test.w(), 3),
              figures.p(test.p(), Optional.empty())));
    }
    for (Outlier outlier : found.outliers()) {
      rows.add(
          List.of(
              "outlier "
                  + outlier.participant()
                  + at(outlier.at())
                  + ": "
                  + figures.number(outlier.value(), 3),
              "t = " + figures.number(outlier.studentised(), 2),
              figures.p(outlier.p(), Optional.empty())));
    }
    List<ReportBlock> blocks = new ArrayList<>();
    if (!rows.isEmpty()) {
      blocks.add(
          new Table(
              "Checks of assumptions", List.of("check", "statistic", "p"), rows, figures.notes()));
    }
    blocks.add(new Items(found.consequences()));
    return blocks;
  }

  private static String at(Optional<String> level) {
    return level.map(name -> ", " + name).orElse("");
  }
}
