package org.selectiverenderer.study.threshold;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.formats.json.JsonTree;

/** What a participant has answered is never lost, and what comes next follows from it. */
class ThresholdSessionTest extends ThresholdPilotFixture {
  private static List<ThresholdTrial> all(ThresholdSession session, SimulatedObserver observer)
      throws IOException {
    List<ThresholdTrial> trials = new ArrayList<>();
    while (session.next().isPresent()) {
      trials.add(session.next().get());
      answer(session, observer, 1);
    }
    return trials;
  }

  /** Answers that depend on the trial only, so that a break does not change them. */
  private static String steady(ThresholdTrial trial) {
    boolean knows = trial.catches() || trial.rung() < 4 + trial.number() % 3;
    return knows ? trial.right() : trial.choices().get(trial.number() % 2);
  }

  @Test
  void aSessionThatWasCutOffGoesOnWithTheVeryTrialThatItWouldHaveComeTo() throws IOException {
    List<ThresholdTrial> whole = new ArrayList<>();
    try (ThresholdSession session = open("001", false)) {
      while (session.next().isPresent()) {
        whole.add(session.next().get());
        session.answer(session.next().get(), steady(session.next().get()), 1);
      }
    }
    Path log = folder.resolve("threshold/sub-001/trials.jsonl");
    List<String> lines = Files.readAllLines(log);
    // A crash in the middle of writing the thirtieth line.
    Files.writeString(log, String.join("\n", lines.subList(0, 29)) + "\n" + "{\"time\":\"20");

    List<ThresholdTrial> rest = new ArrayList<>();
    try (ThresholdSession session = open("001", true)) {
      while (session.next().isPresent()) {
        rest.add(session.next().get());
        session.answer(session.next().get(), steady(session.next().get()), 1);
      }
    }

    int kept = whole.size() - rest.size();
    assertThat(kept).isBetween(20, 29);
    assertThat(rest).isEqualTo(whole.subList(kept, whole.size()));
    assertThat(told())
        .singleElement()
        .asString()
        .contains("trials.jsonl:30:1", "a copy is in trials-cut-off-01.txt");
    assertThat(log("001")).anyMatch(line -> line.contains("\"event\":\"resumed\""));
    assertThat(log("001").get(29)).contains("\"event\":\"journal-mended\"");
    assertThat(log.resolveSibling("trials-cut-off-01.txt")).hasContent("{\"time\":\"20");
  }

  @Test
  void aThresholdThatACrashKeptFromTheLogIsWrittenOnResume() throws IOException {
    try (ThresholdSession session = open("001", false)) {
      answer(session, observer(study(), 0.1, 3), 1000);
    }
    List<String> lines = log("001");
    assertThat(lines).filteredOn(line -> line.contains("\"event\":\"threshold\"")).hasSize(5);
    Files.write(
        folder.resolve("threshold/sub-001/trials.jsonl"), lines.subList(0, lines.size() - 2));

    open("001", true).close();

    assertThat(log("001")).filteredOn(line -> line.contains("\"event\":\"threshold\"")).hasSize(5);
    assertThat(log("001").get(log("001").size() - 1)).contains("\"event\":\"pilot-finished\"");
    assertThatThrownBy(() -> open("001", true)).hasMessageContaining("is complete");
  }

  @Test
  void everyTrialIsOnTheDiskWithAllThatIsKnownOfIt() throws IOException {
    try (ThresholdSession session = open("001", false)) {
      ThresholdTrial trial = session.next().orElseThrow();
      session.answer(trial, trial.right(), 734);

      var event = JsonTree.parse(log("001").get(1));
      assertThat(event.path("event").asText()).isEqualTo("trial");
      assertThat(event.path("object").asText()).isEqualTo(trial.object());
      assertThat(event.path("polygons").asInt()).isEqualTo(LADDER.at(trial.rung()));
      assertThat(event.path("correct").asBoolean()).isTrue();
      assertThat(event.path("ms").asInt()).isEqualTo(734);
    }
  }

  @Test
  void theSameParticipantHasTheSameTrialsAndAnotherHasOthers() throws IOException {
    ThresholdStudy study = study();
    List<List<ThresholdTrial>> trials = new ArrayList<>();
    for (String participant : List.of("001", "001", "002")) {
      InterleavedTracks pilot = new InterleavedTracks(study, ladders(study), participant);
      List<ThresholdTrial> own = new ArrayList<>();
      for (int i = 0; i < 40; i++) {
        ThresholdTrial trial = pilot.next().orElseThrow();
        assertThat(pilot.next()).contains(trial);
        own.add(trial);
        pilot.answered(trial, steady(trial));
      }
      trials.add(own);
    }
    assertThat(trials.get(1)).isEqualTo(trials.get(0));
    assertThat(trials.get(2)).isNotEqualTo(trials.get(0));
  }

  @Test
  void noObjectComesTwiceInARowAndBothSidesAndAllViewsComeUp() throws IOException {
    List<ThresholdTrial> trials;
    ThresholdStudy study = study();
    try (ThresholdSession session = open("001", false)) {
      trials = all(session, observer(study, 0.1, 5));
    }
    for (int i = 1; i < 60; i++) {
      assertThat(trials.get(i).object()).isNotEqualTo(trials.get(i - 1).object());
    }
    assertThat(trials).extracting(ThresholdTrial::right).contains("left", "right");
    assertThat(trials).extracting(ThresholdTrial::view).contains(0, 1);
    assertThat(trials)
        .filteredOn(ThresholdTrial::catches)
        .hasSizeBetween(trials.size() / 25, trials.size() / 4)
        .allSatisfy(trial -> assertThat(trial.catching()).isNotEqualTo(trial.object()));
  }

  @Test
  void recognisingAsksForOneOfFourNamesAndNeverShowsFewerPolygonsAgain() throws IOException {
    write("recognise", "");
    ThresholdStudy study = study();
    List<ThresholdTrial> trials;
    try (ThresholdSession session = open("001", false)) {
      trials = all(session, observer(study, 0.2, 2));
    }
    assertThat(trials)
        .allSatisfy(
            trial ->
                assertThat(trial.choices())
                    .hasSize(4)
                    .doesNotHaveDuplicates()
                    .contains(trial.object()));
    for (ThresholdStudy.Judged judged : study.objects()) {
      assertThat(trials.stream().filter(trial -> trial.object().equals(judged.object())))
          .extracting(ThresholdTrial::rung)
          .isSorted()
          .doesNotHaveDuplicates()
          .contains(0);
    }
  }

  @Test
  void aSecondProgramIsRefusedWhileOneRuns() throws IOException {
    try (ThresholdSession session = open("001", false)) {
      answer(session, observer(study(), 0.1, 1), 3);
      assertThatThrownBy(() -> open("001", true)).hasMessageContaining(" is being run by test 1 ");
      answer(session, observer(study(), 0.1, 1), 3);
    }
    assertThat(log("001")).hasSize(7);
  }

  @Test
  @Timeout(value = 120, unit = TimeUnit.SECONDS)
  void aSecondProcessIsRefusedUntilTheFirstIsGoneHoweverItEnds()
      throws IOException, InterruptedException {
    Process first =
        new ProcessBuilder(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                System.getProperty("java.class.path"),
                PilotHoldingProcess.class.getName(),
                file.toString(),
                "001")
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    try {
      assertThat(first.inputReader(UTF_8).readLine()).isEqualTo("held");
      for (boolean resume : new boolean[] {true, false}) {
        assertThatThrownBy(() -> open("001", resume)).isInstanceOf(IOException.class);
      }
      assertThatThrownBy(() -> open("001", true))
          .hasMessageStartingWith(
              folder.resolve("threshold/sub-001")
                  + " is being run by held 1 (process "
                  + first.pid()
                  + " on ");
    } finally {
      first.destroyForcibly().waitFor();
    }
    try (ThresholdSession session = open("001", true)) {
      assertThat(session.pilot().trials()).isEqualTo(1);
    }
  }

  @Test
  void aSessionIsNeitherBegunTwiceNorResumedWithoutABeginningNorAfterAChange() throws IOException {
    assertThatThrownBy(() -> open("001", true)).hasMessageContaining("leave --resume out");
    open("001", false).close();
    assertThatThrownBy(() -> open("001", false)).hasMessageContaining("--resume continues it");
    ThresholdStudy study = study();
    assertThatThrownBy(
            () ->
                ThresholdSession.open(
                    study,
                    ladders(study),
                    new ThresholdSession.Opening("001", "other", "test 1", true, true),
                    problems))
        .hasMessageContaining("have changed since this participant began");
    assertThatThrownBy(() -> open("002", true)).isInstanceOf(IOException.class);
    assertThat(folder.resolve("threshold/sub-002")).doesNotExist();
  }

  @Test
  void aLineThatIsMissingFromTheMiddleIsFound() throws IOException {
    try (ThresholdSession session = open("001", false)) {
      answer(session, observer(study(), 0.1, 1), 12);
    }
    Path log = folder.resolve("threshold/sub-001/trials.jsonl");
    List<String> lines = new ArrayList<>(Files.readAllLines(log));
    lines.remove(5);
    Files.write(log, lines, StandardOpenOption.TRUNCATE_EXISTING);

    assertThatThrownBy(() -> open("001", true))
        .hasMessageContaining("is not the one that came next");
  }
}
