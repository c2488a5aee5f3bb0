package org.selectiverenderer.statistics.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.ResponsesCsvWriter;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.simulation.RecognitionListSpec;
import org.selectiverenderer.statistics.simulation.SimulationModel;
import org.selectiverenderer.statistics.simulation.StudySimulator;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Reports against golden files. After a change that is meant, {@code mvn test -Dtest=ReportsTest
 * -Dreports.update=true} writes them anew.
 */
class ReportsTest {
  static final Provenance MADE =
      new Provenance("selective-renderer", "0.1.0", LocalDate.of(2026, 1, 15), false);

  private static final DataSource DATA = DataSource.none("data.csv");
  private static final Path GOLDEN =
      Path.of("modules/statistics/src/test/resources/org/selectiverenderer/statistics/report");

  @Test
  void aStudyAsText() throws IOException {
    assertGolden("study.txt", StudyReport.text(study(), MADE));
  }

  @Test
  void aStudyAsJson() throws IOException {
    assertGolden("study.json", StudyReport.json(study(), MADE));
  }

  @Test
  void scoresAsTidyAndWideCsv() throws IOException {
    assertGolden("tidy.csv", StudyReport.tidyCsv(study(), MADE));
    assertGolden("wide.csv", StudyReport.wideCsv(study(), MADE));
  }

  @Test
  void aRepeatedMeasuresDesignOfThreeLevels() throws IOException {
    Anova anova = Anova.of(threeLevels(), AnovaOptions.DEFAULT.withRawBound(1));
    assertGolden("anova.txt", AnovaReport.text(anova, List.of(), DATA, MADE));
    assertGolden("anova.json", AnovaReport.json(anova, List.of(), DATA, MADE));
  }

  @Test
  void theHtmlPageLoadsNothingAndHasItsPlots() {
    String html = StudyReport.html(study(), MADE);
    assertThat(html)
        .startsWith("<!DOCTYPE html>")
        .doesNotContain("src=", "<script", "<link", "@import", "url(")
        .contains("<svg", "kitchen, d′, all answers", "sim-001");
    assertThat(html.replace("http://www.w3.org/2000/svg", "")).doesNotContain("http");
  }

  /** Bad data end in footnotes, never in NaN. */
  @Test
  void noReportShowsANumberThatIsNone() {
    StudyAnalysis bad =
        read(
            "participant,condition,area,object,consistency,present,response,confidence\n"
                + "a,high,kitchen,cup,consistent,yes,yes,4\n"
                + "a,high,kitchen,fork,consistent,no,no,4\n"
                + "b,selective,kitchen,cup,consistent,yes,yes,4\n"
                + "b,selective,kitchen,fork,consistent,no,no,4\n"
                + "c,selective,kitchen,cup,consistent,yes,yes,4\n"
                + "c,selective,kitchen,fork,consistent,no,no,1\n"
                + "d,high,office,cup,consistent,yes,yes,4\n");
    Anova constant =
        Anova.of(
            new FactorialDesign(
                "y",
                new Factor("type", List.of("a", "b")),
                new Factor("group", List.of("x", "y")),
                List.of(
                    new Subject("1", 0, List.of(1.0, 1.0)),
                    new Subject("2", 0, List.of(1.0, 1.0)),
                    new Subject("3", 1, List.of(1.0, 1.0)))),
            AnovaOptions.DEFAULT);
    for (String report :
        List.of(
            StudyReport.text(bad, MADE),
            StudyReport.html(bad, MADE),
            StudyReport.json(bad, MADE),
            StudyReport.tidyCsv(bad, MADE),
            StudyReport.wideCsv(bad, MADE),
            AnovaReport.text(constant, List.of(), DATA, MADE),
            AnovaReport.html(constant, List.of(), DATA, MADE),
            AnovaReport.json(constant, List.of(), DATA, MADE))) {
      assertThat(report).doesNotContain("NaN", "Infinity", "\u221e");
    }
    assertThat(StudyReport.text(bad, MADE)).contains("(a) ");
    assertThat(AnovaReport.text(constant, List.of(), DATA, MADE)).contains("zero variance");
    assertThat(AnovaReport.json(constant, List.of(), DATA, MADE))
        .contains("\"F\" : null", "\"undefined\"");
  }

  @Test
  void oneConditionOnlyIsAnalysedWithoutItsEffectAndSaidSo() {
    StudyAnalysis study =
        StudyAnalysis.of(
            ResponsesReader.parse(
                    "r.csv", answers(List.of("high")), Optional.empty(), new ProblemCollector())
                .orElseThrow(),
            DetectionScorer.DEFAULT,
            AnovaOptions.DEFAULT);
    assertThat(StudyReport.json(study, MADE))
        .contains("There is one condition only, high: no effect of condition.")
        .contains("\"effect\" : \"object type\"")
        .doesNotContain("\"effect\" : \"condition\"");
  }

  @Test
  void everyReportSaysOfWhichFileItIsAndByWhichVersion() {
    StudyAnalysis study = study();
    String sum = study.responses().source().sha256().orElseThrow();
    assertThat(sum).matches("[0-9a-f]{64}");
    for (String page : List.of(StudyReport.text(study, MADE), StudyReport.html(study, MADE))) {
      assertThat(page.replaceAll("\\s+", " "))
          .contains("Made by selective-renderer 0.1.0 on 2026-01-15 from r.csv, SHA-256 " + sum);
    }
    assertThat(StudyReport.tidyCsv(study, MADE).lines())
        .allMatch(line -> line.endsWith(",source_sha256") || line.endsWith("r.csv," + sum));
    assertThat(StudyReport.json(study, MADE))
        .contains("\"source_sha256\" : \"" + sum + "\"", "\"version\" : \"0.1.0\"")
        .doesNotContain("2026-01-15");
    Provenance dated = new Provenance("p", "1", LocalDate.of(2026, 5, 1), true);
    assertThat(StudyReport.json(study, dated)).contains("\"date\" : \"2026-05-01\"");
    assertThat(StudyReport.wideCsv(study, dated).lines())
        .allMatch(line -> line.matches(".*,(date|2026-05-01)"));
  }

  /** Scores that are missing are said where exclusions are, also when no row is left out. */
  @Test
  void participantsWithoutAScoreStandBesideTheExclusions() {
    String text = StudyReport.text(read(answers(List.of("high", "selective"))), MADE);
    assertThat(text)
        .contains("Rows: none is left out; every answer of the file is used.")
        .containsPattern("kitchen, confidence 5: \\d+ of 14\\.");
    assertThat(StudyReport.json(study(), MADE)).contains("\"without_score\"");
  }

  /** "high" is a condition; the level of confidence has another name. */
  @Test
  void noLevelOfConfidenceIsNamedAsACondition() {
    assertThat(StudyReport.text(study(), MADE))
        .contains("d′ conf. 5", "log β conf. 3–5")
        .doesNotContain("d′ high", "d′ mod", "d′ un ");
  }

  @Test
  void filesForAManuscriptHaveNamesForAnyArea() {
    StudyAnalysis study =
        read(
            answers(List.of("high", "selective"))
                .replace(",kitchen,", ",Kitchen / 1,")
                .replace(",office,", ",kitchen 1,"));
    assertThat(ManuscriptFiles.figures(study).keySet())
        .contains(
            "kitchen-1-d_prime-all.svg",
            "kitchen-1-2-log_beta-confidence-3-5.svg",
            "kitchen-1-inconsistent-roc.svg",
            "kitchen-1-2-neutral-roc.svg");
    assertThat(ManuscriptFiles.figures(study).values()).allMatch(svg -> svg.startsWith("<?xml"));
    assertThat(ManuscriptFiles.tables(study, MADE).keySet())
        .contains(
            "kitchen-1-means.html", "kitchen-1-2-effects.tex", "sentences.txt", "methods.txt");
    assertThat(ManuscriptFiles.tables(study, MADE).values())
        .noneMatch(text -> text.contains("NaN") || text.contains("Infinity"));
  }

  @Test
  void aCorrectionOverTheStudyIsAColumnAndIsStated() {
    StudyAnalysis study =
        StudyAnalysis.of(
            study().responses(),
            DetectionScorer.DEFAULT,
            AnovaOptions.DEFAULT,
            MultipleTestingCorrection.HOLM);
    assertThat(StudyReport.text(study, MADE).replaceAll("\\s+", " "))
        .contains("p corrected", "all areas at one level of confidence together: Holm (1979)");
    assertThat(StudyReport.text(study(), MADE)).doesNotContain("p corrected");
  }

  private static FactorialDesign threeLevels() {
    double[][] rows = {
      {1.2, 2.1, 2.9},
      {0.8, 1.9, 3.5},
      {1.5, 1.4, 2.2},
      {0.4, 2.5, 2.0},
      {1.1, 1.7, 4.1},
      {2.0, 2.2, 2.6},
      {1.9, 3.1, 2.8}
    };
    List<Subject> subjects = new ArrayList<>();
    for (double[] row : rows) {
      subjects.add(
          new Subject("s" + subjects.size(), subjects.size() % 2, List.of(row[0], row[1], row[2])));
    }
    return new FactorialDesign(
        "score",
        new Factor("level", List.of("low", "middle", "high")),
        new Factor("group", List.of("first", "second")),
        subjects);
  }

  /** Fourteen simulated participants; one answer is missing, one is out of range. */
  private static StudyAnalysis study() {
    String text =
        answers(List.of("high", "high-low", "selective"))
            .replaceFirst("(sim-001,.*,)\\d\n", "$19\n")
            .replaceFirst("(sim-005,.*,)(yes|no),\\d\n", "$1,\n");
    return read(text);
  }

  private static StudyAnalysis read(String text) {
    return StudyAnalysis.of(
        ResponsesReader.parse("r.csv", text, Optional.empty(), new ProblemCollector())
            .orElseThrow(),
        DetectionScorer.DEFAULT,
        AnovaOptions.DEFAULT);
  }

  private static String answers(List<String> conditions) {
    List<Double> ones = conditions.stream().map(name -> 1.0).toList();
    SimulationModel model =
        new SimulationModel(
            conditions,
            ones,
            ones.stream().map(one -> 0.1).toList(),
            0.3,
            0.2,
            -0.2,
            0.3,
            List.of(
                new RecognitionListSpec("kitchen", "consistent", 6),
                new RecognitionListSpec("kitchen", "inconsistent", 4),
                new RecognitionListSpec("office", "neutral", 5)));
    return ResponsesCsvWriter.of(StudySimulator.responses(model, 14, 5));
  }

  private static void assertGolden(String name, String text) throws IOException {
    Path file = GOLDEN.resolve(name);
    if (Boolean.getBoolean("reports.update")) {
      Files.createDirectories(GOLDEN);
      Files.writeString(file, text, StandardCharsets.UTF_8);
    }
    assertThat(text).isEqualTo(Files.readString(file).replace("\r\n", "\n"));
  }
}
