package org.selectiverenderer.study.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.report.DesignReport;
import org.selectiverenderer.statistics.report.DesignReport.Cells;
import org.selectiverenderer.statistics.report.DesignReport.Part;
import org.selectiverenderer.study.analysis.TrialAnalyses.Analysis;
import org.selectiverenderer.study.session.LoadedStudy;

/** Makes the report of a study's analyses. */
public final class StudyReportOfTrials {
  private final LoadedStudy study;
  private final AnovaOptions options;

  public StudyReportOfTrials(LoadedStudy study, AnovaOptions options) {
    this.study = study;
    this.options = options;
  }

  /**
   * Returns the report.
   *
   * @param tables further tables for each of the analyses, such as those of R
   */
  public DesignReport of(List<Analysis> analyses, List<List<Cells>> tables) {
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < analyses.size(); i++) {
      Part part = part(analyses.get(i));
      for (Cells table : tables.isEmpty() ? List.<Cells>of() : tables.get(i)) {
        part = part.with(table);
      }
      parts.add(part);
    }
    return new DesignReport("Analysis of " + study.study().name(), parts, remarks(), options);
  }

  private Part part(Analysis analysis) {
    Optional<Anova> anova =
        analysis.data().obstacle().isEmpty()
            ? Optional.of(Anova.of(analysis.data(), options))
            : Optional.empty();
    return new Part(
        analysis.plan().name(),
        analysis.planned(),
        analysis.plan().hypothesis(),
        analysis.method(),
        analysis.counts(),
        analysis.data(),
        anova,
        analysis.exclusions(),
        List.of());
  }

  private List<String> remarks() {
    int planned = study.study().design().analyses().size();
    return List.of(
        planned == 0
            ? "The study file plans no analysis (key \"analysis\"), so all are exploratory."
            : "The study file plans %d of these analyses; they are in its order, and say so."
                .formatted(planned));
  }
}
