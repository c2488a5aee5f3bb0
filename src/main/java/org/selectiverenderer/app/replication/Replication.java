package org.selectiverenderer.app.replication;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.polygon.ScenePolygonCounter;
import org.selectiverenderer.polygon.SceneStatistics;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import org.selectiverenderer.statistics.report.Provenance;
import org.selectiverenderer.statistics.report.StudyReport;
import org.selectiverenderer.statistics.study.StudyAnalysis;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.rehearsal.PlanReport;
import org.selectiverenderer.study.session.CollectedAnswers;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PaperAnswers;
import org.selectiverenderer.study.session.StudyPlan;

/**
 * Makes the thesis's study anew in a folder: the study with its plan and sessions of simulated
 * participants, their answers and the analysis, and a page that has the thesis's tables and figures
 * beside what comes out. The same seed gives the same answers and the same page.
 *
 * @param participants number of simulated participants
 * @param seed of the plan and of the participants
 */
public record Replication(Path folder, Path scene, int participants, long seed) {
  /** The page. */
  public static final String PAGE = "index.html";

  /** The folder of the study's scenes. */
  private static final String SCENES = "scenes";

  private static final String RESPONSES = "responses.csv";

  /** An answer without confidence counts as "no", which is what the thesis's tables look like. */
  private static final DetectionScorer SCORING =
      new DetectionScorer(ExtremeRateCorrection.LOG_LINEAR, LowConfidencePolicy.AS_NO);

  /** Participants between two messages. */
  private static final int TOLD = 18;

  /** Returns the study file that {@link #run} writes. */
  public Path study() {
    return folder.resolve("study").resolve(StudyTemplate.STUDY);
  }

  /**
   * Makes everything.
   *
   * @param problems receives what is wrong with the scene or the study
   * @param progress receives a sentence now and then
   * @return how close the replication comes, a line for each kind of result; empty if there are
   *     errors
   * @throws IOException if the folder exists and is not empty, or a file cannot be read or written
   */
  public Optional<List<String>> run(
      Provenance provenance, ProblemCollector problems, Consumer<String> progress)
      throws IOException {
    requireNew();
    SceneStatistics polygons = ScenePolygonCounter.of(scene, List.of(), problems);
    Path copy = new SceneCopy(scene, study().resolveSibling(SCENES)).write(problems);
    Path file = StudyTemplate.write(study().getParent(), copy, participants, seed);
    Optional<LoadedStudy> material = LoadedStudy.read(file, problems);
    if (material.isEmpty()) {
      return Optional.empty();
    }
    ReplicatedSessions sessions =
        new ReplicatedSessions(
            material.get(), seed, provenance.program() + " " + provenance.version());
    StudyPlan plan = StudyPlan.of(material.get().study(), participants);
    for (int number = 1; number <= participants; number++) {
      sessions.run(number, problems);
      if (number % TOLD == 0 || number == participants) {
        progress.accept("sessions: %d of %d".formatted(number, participants));
      }
    }
    CollectedAnswers answers = collected(material.get(), problems);
    Optional<Responses> responses =
        ResponsesReader.parse(RESPONSES, answers.responses(), Optional.empty(), problems);
    if (responses.isEmpty()) {
      return Optional.empty();
    }
    progress.accept("analysing %d answers".formatted(responses.get().usable().size()));
    StudyAnalysis analysis = StudyAnalysis.of(responses.get(), SCORING, AnovaOptions.DEFAULT);
    ReplicationFindings findings = ReplicationFindings.of(polygons, analysis, sessions);
    Map<String, String> files = new LinkedHashMap<>();
    files.put(PAGE, ReplicationPage.html(this, findings, sessions.held(), provenance));
    files.put("report.html", StudyReport.html(analysis, provenance));
    files.put("plan.html", PlanReport.html(plan));
    files.put(RESPONSES, answers.responses());
    files.put("answers.csv", answers.others());
    files.put("scores.csv", StudyReport.tidyCsv(analysis, provenance));
    files.putAll(ReplicationTables.of(findings));
    FileTransaction writing = new FileTransaction(FileOperations.PRIVATE);
    files.forEach(
        (name, text) ->
            writing.addNew(folder.resolve(name), text.getBytes(StandardCharsets.UTF_8)));
    writing.commit();
    return Optional.of(
        ReplicationSummary.of(findings).stream()
            .map(line -> "%s (%s): %s".formatted(line.about(), line.basis(), line.finding()))
            .toList());
  }

  private void requireNew() throws IOException {
    if (!Files.exists(folder)) {
      return;
    }
    if (!Files.isDirectory(folder)) {
      throw new IOException(folder + " is a file; name a new folder. Nothing was written");
    }
    try (Stream<Path> inside = Files.list(folder)) {
      if (inside.findAny().isPresent()) {
        throw new IOException(folder + " is not empty; name a new folder. Nothing was written");
      }
    }
  }

  /** Collects the answers; that each session is a simulated one need not be told. */
  private static CollectedAnswers collected(LoadedStudy material, ProblemCollector problems)
      throws IOException {
    ProblemCollector own = new ProblemCollector();
    CollectedAnswers answers =
        CollectedAnswers.of(
            material, OptionalInt.empty(), PaperAnswers.read(material, List.of(), own), own);
    own.list().stream()
        .filter(problem -> problem.severity() == Problem.Severity.ERROR)
        .forEach(problems::add);
    return answers;
  }
}
