package org.selectiverenderer.statistics.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.ResponsesCsv;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.detection.Scoring;
import org.selectiverenderer.statistics.simulation.ObjectList;
import org.selectiverenderer.statistics.simulation.SimulatedStudy;
import org.selectiverenderer.statistics.simulation.StudyModel;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * The report in docs is the one that docs/statistics.md tells how to make. After a change that is
 * meant, {@code mvn test -Dtest=StudyReportPageTest -Dreports.update=true} writes it anew.
 */
class StudyReportPageTest {
  private static final Path PAGE = Path.of("docs/study-report.html");

  @Test
  void theReportInDocsIsWhatTheProgramWrites() throws IOException {
    String html = StudyReport.html(study(), ReportsTest.MADE);
    if (Boolean.getBoolean("reports.update")) {
      Files.writeString(PAGE, html, StandardCharsets.UTF_8);
    }
    assertThat(Files.readString(PAGE).replace("\r\n", "\n").equals(html))
        .as("docs/study-report.html is up to date")
        .isTrue();
  }

  /** {@code experiment simulate --participants 54 --d-prime 1.1 --seed 2009}. */
  private static StudyAnalysis study() {
    StudyModel model =
        new StudyModel(
            List.of("high", "high-low", "selective"),
            List.of(1.1, 1.1, 1.1),
            List.of(0.0, 0.0, 0.0),
            0.3,
            0.25,
            0,
            0.4,
            ObjectList.THESIS);
    String answers = ResponsesCsv.of(SimulatedStudy.responses(model, 54, 2009));
    return StudyAnalysis.of(
        ResponsesReader.parse("simulated.csv", answers, Optional.empty(), new Problems())
            .orElseThrow(),
        Scoring.DEFAULT,
        AnovaOptions.DEFAULT);
  }
}
