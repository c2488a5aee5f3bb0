package org.selectiverenderer.statistics.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.simulation.RecognitionListSpec;
import org.selectiverenderer.statistics.simulation.SimulationModel;
import org.selectiverenderer.statistics.simulation.StudySimulator;
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
    SimulationModel model =
        new SimulationModel(
            List.of("high", "high-low", "selective"),
            List.of(1.1, 1.1, 1.1),
            List.of(0.0, 0.0, 0.0),
            0.3,
            0.25,
            0,
            0.4,
            RecognitionListSpec.THESIS);
    String answers = ResponsesCsvWriter.of(StudySimulator.responses(model, 54, 2009));
    return StudyAnalysis.of(
        ResponsesReader.parse("simulated.csv", answers, Optional.empty(), new ProblemCollector())
            .orElseThrow(),
        DetectionScorer.DEFAULT,
        AnovaOptions.DEFAULT);
  }
}
