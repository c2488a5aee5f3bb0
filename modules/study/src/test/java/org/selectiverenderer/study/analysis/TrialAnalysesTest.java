package org.selectiverenderer.study.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.List;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.Measurement;
import org.selectiverenderer.statistics.report.Provenance;
import org.selectiverenderer.study.analysis.TrialAnalyses.Analysis;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.TrialSimulator;

class TrialAnalysesTest {
  private static final String STUDY =
      """
      {"name": "S", "scene": "room.x3d", "participants": 4, "seed": 1,
       "factors": [
        {"name": "quality", "varies": "within", "levels": [{"name": "full"}, {"name": "low"}]},
        {"name": "age", "varies": "between", "levels": [{"name": "young"}, {"name": "old"}]}],
       "blocks": [
        {"name": "training", "practice": {"correct": 0.5}, "stimuli": "list.csv",
         "trial": [{"show": "exposure", "seconds": 1, "keys": ["f", "j"], "correct": "{answer}"}]},
        {"name": "main", "stimuli": "list.csv",
         "trial": [{"show": "exposure", "seconds": 1, "keys": ["f", "j"], "correct": "{answer}"},
          {"show": "questions", "questionnaire": "sure"}]}],
       "analysis": [ANALYSIS],
       "questionnaires": [{"file": "sure.json", "when": "in-trials", "name": "sure"}]}
      """;

  private static final String HEAD =
      "participant,session,group,block,trial,round,quality,age,item,answer,response,ms,correct,"
          + "sure.sure,sure.why\n";

  @TempDir private Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  @BeforeEach
  void files() throws IOException {
    Files.writeString(folder.resolve("room.x3d"), "<X3D><Scene/></X3D>");
    Files.writeString(folder.resolve("list.csv"), "item,answer\na,f\nb,j\n");
    Files.writeString(
        folder.resolve("sure.json"),
        """
        {"name": "sure", "pages": [{"questions": [
          {"id": "sure", "kind": "scale", "from": 1, "to": 5, "text": "How sure?",
           "least": "not", "most": "very"},
          {"id": "why", "kind": "text", "text": "Why?"}]}]}
        """);
  }

  private Optional<LoadedStudy> study(String analysis) throws IOException {
    Path file = folder.resolve("study.json");
    Files.writeString(file, STUDY.replace("ANALYSIS", analysis));
    return LoadedStudy.read(file, problems);
  }

  private TrialAnalyses analyses(String plan, String rows) throws IOException {
    LoadedStudy study = study(plan).orElseThrow(() -> new AssertionError(problems.list()));
    byte[] content = (HEAD + rows).getBytes(StandardCharsets.UTF_8);
    return new TrialAnalyses(
        study,
        StudyTrials.read(
                "trials.csv",
                content,
                DataSource.of("trials.csv", content),
                study.study().design(),
                problems)
            .orElseThrow(() -> new AssertionError(problems.list())));
  }

  private Analysis planned(String plan, String rows) throws IOException {
    return analyses(plan, rows).planned().get(0);
  }

  private static String row(
      String participant, String age, String quality, String answer, String response, String ms) {
    return "%s,1,%s,main,1,1,%s,%s,a,%s,%s,%s,%s,3,words\n"
        .formatted(
            participant,
            age,
            quality,
            age,
            answer,
            response,
            ms,
            response.isEmpty() || !response.equals(answer) ? "no" : "yes");
  }

  /** A trial of each of four participants at each quality. */
  private static String complete() {
    StringBuilder rows = new StringBuilder();
    for (int i = 1; i <= 4; i++) {
      String age = i % 2 == 1 ? "young" : "old";
      rows.append(row("00" + i, age, "full", "f", "f", Integer.toString(400 + 10 * i)));
      rows.append(row("00" + i, age, "low", "f", "f", Integer.toString(500 + 20 * i)));
    }
    return rows.toString();
  }

  private static double value(Analysis analysis, String participant, String quality) {
    return analysis.values().stream()
        .filter(each -> each.participant().equals(participant))
        .filter(each -> each.levels().contains(quality))
        .mapToDouble(Measurement::value)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void whatIsLeftOutIsCounted() throws IOException {
    Analysis analysis =
        planned(
            "{\"name\": \"T\", \"hypothesis\": \"H\", \"measure\": \"ms\", \"by\": [\"quality\"],"
                + " \"where\": {\"correct\": \"yes\"},"
                + " \"exclude\": {\"ms\": {\"below\": 150, \"above\": 1000}}}",
            complete()
                + row("001", "young", "full", "f", "f", "149.9")
                + row("001", "young", "full", "f", "f", "150")
                + row("001", "young", "low", "f", "f", "1000.1")
                + row("001", "young", "low", "f", "j", "450")
                + row("002", "old", "low", "f", "", "")
                // Trials of practice never count.
                + row("002", "old", "low", "f", "f", "1").replace(",main,", ",training,"));
    assertThat(analysis.planned()).isTrue();
    assertThat(analysis.plan().hypothesis()).isEqualTo("H");
    assertThat(analysis.counts())
        .containsExactly(
            "11 trials of 13.",
            "1 trial with ms below 150 left out.",
            "1 trial with ms above 1000 left out.");
    assertThat(value(analysis, "001", "full")).isEqualTo((410 + 150) / 2.0);
    assertThat(value(analysis, "001", "low")).isEqualTo(520);
    assertThat(analysis.data().subjects()).hasSize(4);
    assertThat(analysis.within()).containsExactly("quality");
    assertThat(analysis.between()).isEmpty();
  }

  @Test
  void aMixedDesignHasItsGroupsAndParticipantsWithoutACellAreLeftOut() throws IOException {
    Analysis analysis =
        planned(
            "{\"name\": \"T\", \"measure\": \"ms\", \"by\": [\"age\", \"quality\"]}",
            complete() + row("005", "old", "full", "f", "f", "500"));
    assertThat(analysis.between()).containsExactly("age");
    assertThat(analysis.data().between().levels()).containsExactly("young", "old");
    assertThat(analysis.data().group(1)).extracting("id").containsExactly("002", "004");
    assertThat(analysis.data().subjects().get(1).values()).containsExactly(420.0, 540.0);
    assertThat(analysis.exclusions())
        .singleElement()
        .satisfies(
            left -> {
              assertThat(left.participant()).isEqualTo("005");
              assertThat(left.reason()).isEqualTo("has no ms at low; the participant is left out");
            });
  }

  @Test
  void severalTrialsBecomeTheirMedianOrShare() throws IOException {
    String rows =
        complete()
            + row("001", "young", "full", "f", "j", "10")
            + row("001", "young", "full", "f", "", "");
    assertThat(
            value(
                planned(
                    "{\"name\": \"T\", \"measure\": \"ms\", \"by\": [\"quality\"],"
                        + " \"aggregate\": \"median\"}",
                    rows + row("001", "young", "full", "f", "f", "300")),
                "001",
                "full"))
        .isEqualTo(300);
    assertThat(
            value(
                planned("{\"name\": \"T\", \"measure\": \"correct\", \"by\": [\"quality\"]}", rows),
                "001",
                "full"))
        .isCloseTo(1 / 3.0, Offset.offset(1e-12));
  }

  @Test
  void sensitivityIsOfHitsAndFalseAlarmsCorrectedLogLinearly() throws IOException {
    StringBuilder rows = new StringBuilder();
    // Of 4 signals 3 hits, of 3 trials without one 1 false alarm; one trial has no response.
    for (String response : List.of("f", "f", "f", "j")) {
      rows.append(row("001", "young", "full", "f", response, "500"));
    }
    for (String response : List.of("f", "j", "j", "")) {
      rows.append(row("001", "young", "full", "j", response, "500"));
    }
    // At the other level there are no trials without a signal.
    rows.append(row("001", "young", "low", "f", "f", "500"));
    Analysis analysis =
        planned(
            "{\"name\": \"T\", \"measure\": \"dprime\", \"by\": [\"quality\"],"
                + " \"signal\": {\"answer\": \"f\"}}",
            rows.toString());
    // qnorm(3.5 / 5) - qnorm(1.5 / 4) in R
    assertThat(value(analysis, "001", "full")).isCloseTo(0.843039876672416, Offset.offset(1e-9));
    assertThat(analysis.counts())
        .containsExactly(
            "9 trials.",
            "1 trial without a response that is right or wrong left out.",
            "1 cell of a participant without trials with a signal, or without trials without one,"
                + " left out.");
    assertThat(analysis.data().obstacle()).isPresent();
  }

  @Test
  void withoutAPlanAllNumericMeasuresAreExploratory() throws IOException {
    TrialAnalyses all = analyses("", complete());
    assertThat(all.planned()).isEmpty();
    assertThat(all.exploratory())
        .extracting(analysis -> analysis.plan().name())
        .containsExactly(
            "ms of the block main", "correct of the block main", "sure.sure of the block main");
    assertThat(all.exploratory())
        .allSatisfy(
            analysis -> {
              assertThat(analysis.planned()).isFalse();
              assertThat(analysis.plan().by()).containsExactly("quality", "age");
            });
  }

  @Test
  void whatIsPlannedIsNotExploredAgain() throws IOException {
    assertThat(
            analyses(
                    "{\"name\": \"T\", \"measure\": \"ms\", \"by\": [\"age\", \"quality\"]}",
                    complete())
                .exploratory())
        .extracting(analysis -> analysis.plan().measure())
        .containsExactly("correct", "sure.sure");
  }

  @Test
  void thresholdsOfTheTableAreThoseOfTheStaircases() throws IOException {
    LoadedStudy study =
        LoadedStudy.read(Path.of("docs/examples/levels-of-detail/study.json"), problems)
            .orElseThrow();
    byte[] content =
        new TrialSimulator(study, List.of(), 3).csv(2).getBytes(StandardCharsets.UTF_8);
    Analysis analysis =
        new TrialAnalyses(
                study,
                StudyTrials.read(
                        "t.csv", content, DataSource.none("t"), study.study().design(), problems)
                    .orElseThrow())
            .planned()
            .get(0);
    assertThat(analysis.values()).hasSize(4);
    assertThat(analysis.values()).allMatch(each -> each.value() >= 4 && each.value() <= 24);
    assertThat(analysis.counts()).contains("4 staircases converged.");
  }

  @Test
  void aTableOfAnotherStudyIsRefusedWithItsPlace() throws IOException {
    LoadedStudy study = study("").orElseThrow();
    byte[] other =
        (HEAD + row("001", "young", "full", "f", "f", "1").replace(",full,", ",fine,"))
            .getBytes(StandardCharsets.UTF_8);
    assertThat(
            StudyTrials.read(
                "trials.csv", other, DataSource.none("t"), study.study().design(), problems))
        .isEmpty();
    assertThat(problems.list())
        .extracting(Object::toString)
        .singleElement()
        .asString()
        .contains("trials.csv:2:22")
        .contains("'fine' is no level of the study's factor quality; nothing is analysed");
    byte[] short_ = "participant,ms\n001,1\n".getBytes(StandardCharsets.UTF_8);
    assertThat(
            StudyTrials.read(
                "trials.csv", short_, DataSource.none("t"), study.study().design(), problems))
        .isEmpty();
    assertThat(problems.list().get(1).toString()).contains("the header lacks session, group");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          "measure": "ms", "by": ["qualty"] | 'qualty' is neither a factor nor a column of the stimuli; did you mean 'quality'?
          "measure": "ms", "by": ["age", "age"] | the factor age is named twice
          "measure": "ms", "by": [] | an analysis needs a factor, or a column of the stimuli, to compare by
          "measure": "ms" | "by"
          "measure": "sure", "by": ["age"] | 'sure' is none of ms, correct, dprime, threshold and the questions that trials ask (sure.sure, sure.why); the study is not used
          "measure": "threshold", "by": ["age"] | "threshold" needs a block with a "staircase"
          "measure": "dprime", "by": ["age"] | needs "signal"
          "measure": "ms", "signal": {"answer": "f"}, "by": ["age"] | needs "signal"
          "measure": "dprime", "signal": {"anser": "f"}, "by": ["age"] | 'anser' is neither a column of the stimuli nor a factor; did you mean 'answer'?
          "measure": "dprime", "signal": {"answer": "f"}, "test": "mixed-model", "by": ["age"] | a mixed model is of single trials, which have no dprime
          "measure": "ms", "where": {"corect": "yes"}, "by": ["age"] | 'corect' is no column of the table of trials; did you mean 'correct'?
          "measure": "ms", "where": {"correct": "1"}, "by": ["age"] | "correct" is "yes" or "no", not '1'
          "measure": "ms", "where": {"quality": "ful"}, "by": ["age"] | 'ful' is no level of the factor quality; did you mean 'full'?
          "measure": "ms", "where": {"quality": "full"}, "by": ["quality"] | of the factor quality only one level counts by "where"
          "measure": "ms", "where": {"block": "mian"}, "by": ["age"] | 'mian' is no block
          "measure": "ms", "where": {"sure.y": "1"}, "by": ["age"] | 'sure.y' is none of
          "measure": "ms", "exclude": {"correct": {"below": 1}}, "by": ["age"] | 'correct' has no values to exclude by their size
          "measure": "ms", "exclude": {"sur": {"below": 1}}, "by": ["age"] | 'sur' is none of
          "measure": "ms", "exclude": {"ms": {"under": 1}}, "by": ["age"] | "under"
          "measure": "ms", "aggregate": "sum", "by": ["age"] | 'sum' is not one of mean, median, share
          "measure": "ms", "test": "t", "by": ["age"] | 't' is not one of anova, mixed-model
          """)
  void whatCannotBePlannedIsAnErrorWithItsPlace(String plan, String message) throws IOException {
    assertThat(study("{\"name\": \"T\", %s}".formatted(plan))).isEmpty();
    assertThat(problems.list())
        .as(problems.list().toString())
        .anyMatch(
            problem -> problem.toString().contains(message) && problem.location().line() == 11);
  }

  @Test
  void twoAnalysesHaveTwoNames() throws IOException {
    String plan = "{\"name\": \"T\", \"measure\": \"ms\", \"by\": [\"age\"]}";
    assertThat(study(plan + ", " + plan)).isEmpty();
    assertThat(problems.list().get(0).toString()).contains("the analysis T is planned twice");
  }

  @Test
  void aPlanThatWasChangedAfterASessionBeganIsTold() throws IOException {
    String plan = "{\"name\": \"T\", \"measure\": \"ms\", \"by\": [\"age\"]}";
    LoadedStudy study = study(plan).orElseThrow();
    for (String participant : List.of("001", "002", "003")) {
      Path session = folder.resolve("sub-" + participant + "/ses-01");
      Files.createDirectories(session);
      Files.writeString(session.resolve("events.jsonl"), "{}\n");
      // Of the first participant the file was another one, but its plan the same.
      Files.writeString(
          session.resolve("study.json"),
          STUDY
              .replace("ANALYSIS", participant.equals("001") ? plan : plan.replace("ms", "correct"))
              .replace("\"seed\": 1", "\n\"seed\": 2"));
    }
    List<String> changed = StudyReportOfTrials.withAnotherPlan(study);
    assertThat(changed).containsExactly("002 (session 1)", "003 (session 1)");
    TrialAnalyses all = analyses(plan, complete());
    assertThat(
            new StudyReportOfTrials(study, AnovaOptions.DEFAULT, changed)
                .of(all.planned(), List.of())
                .text(
                    DataSource.none("t"), new Provenance("p", "1", LocalDate.of(2026, 1, 2), false))
                .replace('\n', ' '))
        .contains(
            "The plan was changed after sessions had begun: that of 002 (session 1) and 1 more had"
                + " another one.");
  }
}
