package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.dataset.RecordedStudy;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

/** Sessions that are begun, cut off, resumed and finished. */
class SessionTest extends TwoRoomStudyFixture {
  @Test
  void aHeadLogThatIsThereIsNotWrittenOver() throws IOException {
    try (Session session = begin("001")) {
      SessionStep step = session.remaining().get(0);
      Path log = session.headLog(step);
      Files.writeString(log, "something");
      assertThatThrownBy(() -> session.headLog(step))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("exists already and is not overwritten");
    }
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "its files have no modes")
  void onlyTheAccountThatRunsASessionReadsIt() throws IOException {
    try (Session session = begin("001")) {
      form(session);
    }
    try (Stream<Path> made = Files.walk(folder.resolve("sub-001"))) {
      assertThat(made)
          .hasSizeGreaterThan(5)
          .allSatisfy(
              path ->
                  assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path)))
                      .isEqualTo(Files.isDirectory(path) ? "rwx------" : "rw-------"));
    }
    assertThat(Files.getPosixFilePermissions(folder.resolve("participants.tsv")))
        .containsOnly(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE);
  }

  @Test
  void aStartThatFailsLeavesNoFolderSoThatARerunBeginsAnew() throws IOException {
    LoadedStudy material = material();
    Path items = folder.resolve("r.csv");
    String text = Files.readString(items);
    Files.delete(items);
    assertThatThrownBy(() -> Session.begin(material, "001", 1, OPTIONS, new ProblemCollector()))
        .isInstanceOf(IOException.class);
    assertThat(folder.resolve("sub-001")).doesNotExist();
    Files.writeString(items, text);
    begin("001").close();
    assertThatThrownBy(() -> begin("001"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("exists already");
    assertThat(folder.resolve("sub-001/ses-01/events.jsonl")).exists();
  }

  @Test
  void anAbortNamesTheStepThatWasUnderWay() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      String under = session.remaining().get(0).id();
      assertThat(under).isNotEqualTo("form");
      session.abort();
      assertThat(Files.readAllLines(folder.resolve("sub-001/ses-01/events.jsonl")))
          .last()
          .asString()
          .contains("\"event\":\"aborted\",\"step\":\"" + under + "\"");
    }
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkTakesNoDataElsewhere(@TempDir Path elsewhere) throws IOException {
    Files.createSymbolicLink(folder.resolve("sub-002"), elsewhere);
    assertThatThrownBy(() -> begin("002"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("sub-002 is a link to " + elsewhere);
    assertThat(elsewhere).isEmptyDirectory();
    assertThatThrownBy(() -> RecordedStudy.read(material(), new ProblemCollector()))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("sub-002 is a link to " + elsewhere);
    Files.delete(folder.resolve("sub-002"));

    begin("003").close();
    Path events = folder.resolve("sub-003/ses-01/events.jsonl");
    Path moved = Files.move(events, elsewhere.resolve("events.jsonl"));
    Files.createSymbolicLink(events, moved);
    String before = Files.readString(moved);
    assertThatThrownBy(() -> resume("003")).hasMessageContaining("events.jsonl is a link to");
    assertThat(moved).hasContent(before);
  }

  @Test
  void aSessionThatIsClosedOnceMoreTakesNothingFromAnotherProgramThatRunsItNow()
      throws IOException {
    Session first = begin("001");
    first.close();
    try (Session second = resume("001")) {
      first.close();
      assertThat(second.folder().path().resolve(SessionLock.HOLDER)).exists();
      form(second);
    }
  }

  @Test
  void aCutOffSessionGoesOnAfterItsLastFinishedStepWithTheAnswersSoFar() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      SessionStep.Questions hall = (SessionStep.Questions) session.remaining().get(0);
      session.began(hall, false);
      Question first = session.questionnaire(hall).questions().get(0);
      session.answer(hall, first, new Answer("yes", 2), OptionalLong.of(700), 1);
      session.answer(hall, first, new Answer("no", 2), OptionalLong.of(1900), 1);
    }
    Path events = folder.resolve("sub-001/ses-01/events.jsonl");
    Files.writeString(
        events, "{\"event\":\"step-finished\",\"step\":\"recog", StandardOpenOption.APPEND);
    String before = Files.readString(events);
    try (Session session = resume("001")) {
      assertThat(left(session)).first().isEqualTo("recognition-hall");
      assertThat(session.group()).isPresent();
      SessionStep.Questions hall = (SessionStep.Questions) session.remaining().get(0);
      Question first = session.questionnaire(hall).questions().get(0);
      assertThat(session.answers(hall)).containsOnly(Map.entry(first.id(), new Answer("no", 2)));
      session.began(hall, false);
    }
    String whole = before.substring(0, before.lastIndexOf('\n') + 1);
    String after = Files.readString(events);
    assertThat(after).startsWith(whole);
    assertThat(after.substring(whole.length()).lines())
        .first()
        .asString()
        .contains(
            "\"journal-mended\"", "\"cut_off_line\":", "\"kept_as\":\"events-cut-off-01.txt\"");
    assertThat(after)
        .contains("\"event\":\"resumed\"", "\"finished\":[\"form\"]", "\"run\":2")
        .doesNotContain("recog\"");
    assertThat(folder.resolve("sub-001/ses-01/events-cut-off-01.txt"))
        .hasContent("{\"event\":\"step-finished\",\"step\":\"recog");
    assertThat(JournalContent.read(events).damaged()).isEmpty();
  }

  @Test
  void aLastEventThatLacksOnlyItsLinesEndCounts() throws IOException {
    try (Session session = begin("001")) {
      form(session);
    }
    Path events = folder.resolve("sub-001/ses-01/events.jsonl");
    Files.writeString(events, Files.readString(events).stripTrailing());
    ProblemCollector problems = new ProblemCollector();
    try (Session session = Session.resume(material(), "001", 1, OPTIONS, problems)) {
      assertThat(left(session)).first().isEqualTo("recognition-hall");
    }
    assertThat(problems.list()).isEmpty();
    assertThat(JournalContent.read(events).damaged()).isEmpty();
    assertThat(folder.resolve("sub-001/ses-01/events-cut-off-01.txt")).doesNotExist();
  }

  @Test
  void aDamagedLineInTheMiddleIsSaidAndStaysAndTheOthersAreUsed() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
    }
    Path events = folder.resolve("sub-001/ses-01/events.jsonl");
    String[] lines = Files.readString(events).split("\n");
    int hit = 0;
    while (!lines[hit].contains("\"answer\"")) {
      hit++;
    }
    lines[hit] = lines[hit].replace("\"value\":\"yes\"", "\"value\":\u0001yes");
    String damaged = String.join("\n", lines) + "\n";
    Files.writeString(events, damaged);
    ProblemCollector problems = new ProblemCollector();
    try (Session session = Session.resume(material(), "001", 1, OPTIONS, problems)) {
      assertThat(left(session)).first().isEqualTo("recognition-bath");
    }
    assertThat(problems.list())
        .singleElement()
        .asString()
        .startsWith(events + ":" + (hit + 1) + ":1: this line is damaged and is ignored;");
    assertThat(events)
        .content()
        .startsWith(damaged)
        .contains("\"damaged_lines\":[" + (hit + 1) + "]");
    ProblemCollector collected = new ProblemCollector();
    CollectedAnswers answers =
        CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), collected);
    assertThat(answers.answers()).isEqualTo(1);
    assertThat(collected.list()).first().asString().contains(":" + (hit + 1) + ":1: this line");
  }

  @ParameterizedTest
  @ValueSource(strings = {"../../../elsewhere_run-01", "a_run-/../../../../elsewhere", "x"})
  void aHeadLogThatAJournalNamesElsewhereIsNeitherReadNorConverted(String name) throws IOException {
    begin("001").close();
    Path events = folder.resolve("sub-001/ses-01/events.jsonl");
    long lines = Files.readString(events).lines().count();
    Files.writeString(
        events,
        "{\"time\":\"2026-03-01T12:00:01.000Z\",\"event\":\"step-began\",\"step\":\"form\","
            + "\"run\":1,\"head_log\":\"%s\"}\n".formatted(name),
        StandardOpenOption.APPEND);
    ProblemCollector resumed = new ProblemCollector();
    Session.resume(material(), "001", 1, OPTIONS, resumed).close();
    assertThat(SessionHistory.read(events).headLogs()).isEmpty();
    String place = events + ":" + (lines + 1) + ":1: this line is damaged";
    assertThat(resumed.list()).singleElement().asString().startsWith(place);
    ProblemCollector recorded = new ProblemCollector();
    assertThat(RecordedStudy.read(material(), recorded).sessions())
        .allMatch(session -> session.runs().isEmpty());
    assertThat(recorded.list()).singleElement().asString().startsWith(place);
  }

  @Test
  void whatIsToldIsKnownWithoutReadingTheFileAgain() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      SessionStep.Questions hall = (SessionStep.Questions) session.remaining().get(0);
      session.began(hall, false);
      Files.writeString(folder.resolve("sub-001/ses-01/events.jsonl"), "");
      Question first = session.questionnaire(hall).questions().get(0);
      session.answer(hall, first, new Answer("no", 2), OptionalLong.empty(), 1);
      assertThat(session.answers(hall)).containsOnlyKeys(first.id());
      session.finished(hall, Map.of());
      assertThat(left(session)).first().isEqualTo("recognition-bath");
    }
  }

  @Test
  void aSessionIsNeverBegunTwice() throws IOException {
    begin("001").close();
    assertThatThrownBy(() -> begin("001"))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("--resume continues it, --session 2 begins a new one");
    assertThatThrownBy(() -> resume("002")).hasMessageContaining("has no session to continue");
  }

  @Test
  void aSessionThatIsBeingRunIsNotRunASecondTime() throws IOException {
    try (Session session = begin("001")) {
      assertThat(session.group()).isEmpty();
      assertThatThrownBy(() -> resume("001"))
          .hasMessageContaining("is being run by test (process " + ProcessHandle.current().pid());
    }
    resume("001").close();
  }

  @Test
  void aFinishedSessionIsNotResumed() throws IOException {
    try (Session session = begin("001")) {
      session.refuse();
    }
    assertThatThrownBy(() -> resume("001")).hasMessageContaining("is complete");
  }

  @Test
  void aCrashBetweenTableAndEventDoesNoHarmAndAnotherTableIsKept() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
      answerAll(session, "no", 1);
      answerAll(session, "2", 0);
      session.end();
      session.end();
      Path table = folder.resolve("sub-001/ses-01/responses.csv");
      Files.writeString(table, "something else");
      assertThatThrownBy(session::end).hasMessageContaining("it exists already with other content");
      assertThat(table).hasContent("something else");
    }
  }

  @Test
  void aStudyThatChangedMeanwhileIsSaid() throws IOException {
    begin("001").close();
    Files.writeString(file, Files.readString(file).replace("Two rooms", "Two other rooms"));
    ProblemCollector problems = new ProblemCollector();
    Session.resume(material(), "001", 1, OPTIONS, problems).close();
    assertThat(problems.list())
        .extracting(Problem::message)
        .singleElement()
        .asString()
        .contains("has changed since this session began");
    assertThat(folder.resolve("sub-001/ses-01/study.json")).content().contains("Two rooms");
  }

  @Test
  void itemsThatChangedMeanwhileAreSaid() throws IOException {
    begin("001").close();
    Path items = folder.resolve("r.csv");
    Files.writeString(items, Files.readString(items).replace("hall,boat", "hall,ship"));
    ProblemCollector problems = new ProblemCollector();
    Session.resume(material(), "001", 1, OPTIONS, problems).close();
    assertThat(problems.list())
        .extracting(Problem::message)
        .singleElement()
        .asString()
        .startsWith("r.csv changed since this session began;");
    assertThat(folder.resolve("sub-001/ses-01/events.jsonl"))
        .content()
        .contains("\"files-changed\",\"files\":[\"r.csv\"]");
  }

  @Test
  void aConditionThatIsAskedForTooLateIsSaidNotToBeUsed() throws IOException {
    StudyGroup own;
    try (Session session = begin("001")) {
      form(session);
      own = session.group().orElseThrow();
    }
    StudyGroup high = StudyGroup.of(Condition.HIGH);
    String other = (own.equals(high) ? StudyGroup.of(Condition.SELECTIVE) : high).name();
    SessionOptions options =
        new SessionOptions(Optional.of(other), OptionalDouble.empty(), false, "test");
    ProblemCollector problems = new ProblemCollector();
    Session.resume(material(), "001", 1, options, problems).close();
    Session.begin(material(), "001", 2, options, problems).close();
    assertThat(problems.list())
        .extracting(Problem::message)
        .hasSize(2)
        .allMatch(
            text ->
                text.equals(
                    ("participant 001 keeps the assigned condition %s; --condition %s "
                            + "is ignored")
                        .formatted(own.name(), other)));
  }
}
