package org.selectiverenderer.study.analysis;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.report.DesignReport;
import org.selectiverenderer.statistics.report.DesignReport.Cells;
import org.selectiverenderer.statistics.report.DesignReport.Part;
import org.selectiverenderer.study.analysis.TrialAnalyses.Analysis;
import org.selectiverenderer.study.definition.PlanComparison;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionFolder;

/** Makes the report of a study's analyses. */
public final class StudyReportOfTrials {
  private final LoadedStudy study;
  private final AnovaOptions options;
  private final List<String> changed;

  /**
   * @param changed names of sessions that began with another plan than the study has now
   */
  public StudyReportOfTrials(LoadedStudy study, AnovaOptions options, List<String> changed) {
    this.study = study;
    this.changed = List.copyOf(changed);
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

  /** Returns the names of the sessions that began with another plan than the study has now. */
  public static List<String> withAnotherPlan(LoadedStudy study) throws IOException {
    List<String> changed = new ArrayList<>();
    for (SessionFolder session : SessionFolder.all(study.study())) {
      Path copy = session.path().resolve("study.json");
      if (Files.isRegularFile(copy) && !PlanComparison.same(study.study(), copy)) {
        changed.add(session.participant() + " (session " + session.number() + ")");
      }
    }
    return changed;
  }

  private List<String> remarks() {
    List<String> remarks = new ArrayList<>();
    int planned = study.study().design().analyses().size();
    remarks.add(
        planned == 0
            ? "The study file plans no analysis (key \"analysis\"), so all are exploratory."
            : "The study file plans %d of these analyses; they are in its order, and say so."
                .formatted(planned));
    if (!changed.isEmpty() && planned > 0) {
      remarks.add(
          ("The plan was changed after sessions had begun: that of %s%s had another one. Report what"
                  + " was changed, and why.")
              .formatted(
                  changed.get(0),
                  changed.size() == 1 ? "" : " and %d more".formatted(changed.size() - 1)));
    }
    return remarks;
  }
}
