package org.selectiverenderer.experiment.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.control.Condition;
import org.selectiverenderer.document.ratings.Ratings;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.QuestionItem;
import org.selectiverenderer.schema.Band;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.data.ResponsesReader;

/** Sessions of questionnaires alone, which need no display. */
class SessionTest {
  private static final SessionOptions OPTIONS =
      new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test");

  @TempDir Path folder;
  private Path file = Path.of("");

  @BeforeEach
  void study() throws IOException {
    file = folder.resolve("study.json");
    Files.writeString(
        file,
        """
        {"name": "Two rooms", "conditions": ["high", "selective"], "participants": 4,
         "questionnaires": [{"kind": "recognition", "items": "r.csv"},
                            {"kind": "expectancy", "items": "e.csv"}]}
        """);
    Files.writeString(
        folder.resolve("r.csv"),
        """
        area,object,consistency,present,en
        hall,coat,consistent,yes,Coat
        hall,boat,inconsistent,no,Boat
        bath,soap,consistent,yes,Soap
        """);
    Files.writeString(
        folder.resolve("e.csv"),
        "area,schema,object,en\nhall,HallSchema,coat,Coat\nhall,HallSchema,boat,Boat\n");
  }

  private StudyMaterial material() throws IOException {
    return StudyMaterial.read(file, new Problems()).orElseThrow();
  }

  private Session begin(String id) throws IOException {
    return Session.begin(material(), id, 1, OPTIONS, new Problems());
  }

  private Session resume(String id) throws IOException {
    return Session.resume(material(), id, 1, OPTIONS, new Problems());
  }

  private static List<String> left(Session session) {
    return session.remaining().stream().map(SessionStep::id).toList();
  }

  private static void form(Session session) throws IOException {
    SessionStep step = session.remaining().get(0);
    session.began(step, false);
    session.assign("18-22");
    session.finished(step, Map.of());
  }

  private static void answerAll(Session session, String value, int confidence) throws IOException {
    SessionStep.Questions step = (SessionStep.Questions) session.remaining().get(0);
    session.began(step, false);
    for (QuestionItem item : session.screen(step).items()) {
      session.answer(step, item, new Answer(value, confidence));
    }
    session.finished(step, Map.of());
  }

  @Test
  void aWholeSessionLeavesAnswersThatTheStatisticsAndTheEnricherRead() throws IOException {
    try (Session session = begin("001")) {
      assertThat(left(session))
          .containsExactly("form", "recognition-hall", "recognition-bath", "expectancy-hall");
      form(session);
      answerAll(session, "yes", 4);
      answerAll(session, "no", 1);
      answerAll(session, "2", 0);
      session.end();
    }
    Problems problems = new Problems();
    CollectedAnswers collected =
        CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), problems);
    assertThat(collected.responses())
        .isEqualTo(Files.readString(folder.resolve("sub-001/ses-01/responses.csv")));
    Responses responses =
        ResponsesReader.parse("r", collected.responses(), Optional.empty(), problems).orElseThrow();
    assertThat(responses.usable()).hasSize(3);
    Ratings ratings =
        Ratings.read("ratings.csv", collected.ratings().getBytes(StandardCharsets.UTF_8), problems)
            .orElseThrow();
    assertThat(ratings.means().get("coat").get("HallSchema").band()).isEqualTo(Band.NON_EXPECTANT);
    assertThat(collected.bands())
        .contains("hall,HallSchema,coat,2.000000,1,non-expectant,inconsistent");
    assertThat(problems.list()).isEmpty();
  }

  private List<String> collecting(OptionalInt session, int lines) throws IOException {
    Problems problems = new Problems();
    assertThat(CollectedAnswers.of(material(), session, PaperAnswers.none(), problems).responses())
        .hasLineCount(lines);
    return problems.list().stream()
        .filter(problem -> !problem.message().startsWith("the questions of"))
        .map(Problem::toString)
        .toList();
  }

  @Test
  void ofTwoSessionsTheFirstCompleteOneCountsAndTheOtherIsSaidToBeLeftOut() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
    }
    assertThat(collecting(OptionalInt.empty(), 3)).isEmpty();
    try (Session session = Session.begin(material(), "001", 2, OPTIONS, new Problems())) {
      form(session);
      answerAll(session, "yes", 4);
      answerAll(session, "yes", 4);
      answerAll(session, "2", 0);
    }
    assertThat(collecting(OptionalInt.empty(), 4))
        .singleElement()
        .asString()
        .contains("ses-01/events.jsonl: ")
        .endsWith(
            "2 answers of session 1 of the participant 001 are left out, because "
                + "session 2 counts; --session 1 uses them");
    assertThat(collecting(OptionalInt.of(1), 3))
        .singleElement()
        .asString()
        .contains("5 answers of session 2 of the participant 001 are left out");
    assertThat(collecting(OptionalInt.of(3), 1))
        .anyMatch(line -> line.contains("the participant 001 has no session 3"))
        .hasSize(3);
  }

  @Test
  void answersThatTheStudyNoLongerAsksForAreSaidToBeLeftOut() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
      answerAll(session, "no", 1);
    }
    Path items = folder.resolve("r.csv");
    Files.writeString(items, "area,object,consistency,present,en\nhall,coat,consistent,yes,Coat\n");
    assertThat(collecting(OptionalInt.empty(), 2))
        .anyMatch(line -> line.contains("no longer asks about boat in recognition-hall"))
        .anyMatch(line -> line.contains("the study no longer has recognition-bath"))
        .hasSize(2);
  }

  @Test
  void aParticipantWithAConditionAndNoSessionIsSaidToBeMissing() throws IOException {
    new Participants(material().study()).assign("009", Optional.empty(), "18-22", false);
    assertThat(collecting(OptionalInt.empty(), 1))
        .singleElement()
        .asString()
        .contains("participants.tsv: ", "the participant 009 has no session;");
  }

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
  void aCutOffSessionGoesOnAfterItsLastFinishedStepWithTheAnswersSoFar() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      SessionStep.Questions hall = (SessionStep.Questions) session.remaining().get(0);
      session.began(hall, false);
      QuestionItem first = session.screen(hall).items().get(0);
      session.answer(hall, first, new Answer("yes", 2));
      session.answer(hall, first, new Answer("no", 2));
    }
    Path events = folder.resolve("sub-001/ses-01/events.jsonl");
    Files.writeString(
        events, "{\"event\":\"step-finished\",\"step\":\"recog", StandardOpenOption.APPEND);
    String before = Files.readString(events);
    try (Session session = resume("001")) {
      assertThat(left(session)).first().isEqualTo("recognition-hall");
      assertThat(session.condition()).isPresent();
      SessionStep.Questions hall = (SessionStep.Questions) session.remaining().get(0);
      QuestionItem first = session.screen(hall).items().get(0);
      assertThat(session.answers(hall))
          .containsOnly(Map.entry(first.object(), new Answer("no", 2)));
      session.began(hall, false);
    }
    String after = Files.readString(events);
    assertThat(after).startsWith(before + "\n");
    assertThat(after.substring(before.length()))
        .contains("\"event\":\"resumed\"", "\"finished\":[\"form\"]", "\"run\":2");
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
      assertThat(session.condition()).isEmpty();
      assertThatThrownBy(() -> resume("001")).hasMessageContaining("is already running");
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
    Problems problems = new Problems();
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
    Problems problems = new Problems();
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
  void statusTellsWhoIsDoneAndWhatIsMissing() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
      session.abort("recognition-bath");
    }
    begin("002").close();
    StudyStatus status = StudyStatus.of(material());
    assertThat(status.sessions())
        .extracting(StudyStatus.Row::participant, StudyStatus.Row::state)
        .containsExactly(
            Assertions.tuple("001", StudyStatus.State.ABORTED),
            Assertions.tuple("002", StudyStatus.State.OPEN));
    assertThat(status.sessions().get(0).missing())
        .containsExactly("recognition-bath", "expectancy-hall");
    assertThat(status.groups())
        .extracting(StudyStatus.Group::assigned)
        .containsExactlyInAnyOrder(0, 1);
    assertThat(status.text()).contains("0 of 4 planned participants have finished a session");
    Problems problems = new Problems();
    assertThat(
            CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), problems)
                .responses())
        .hasLineCount(3);
    assertThat(problems.list()).isNotEmpty();
    assertThat(SessionFolder.nextId(material().study())).isEqualTo("003");
  }

  @Test
  void aConditionThatIsAskedForTooLateIsSaidNotToBeUsed() throws IOException {
    Condition own;
    try (Session session = begin("001")) {
      form(session);
      own = session.condition().orElseThrow();
    }
    Condition other = own == Condition.HIGH ? Condition.SELECTIVE : Condition.HIGH;
    SessionOptions options =
        new SessionOptions(Optional.of(other), OptionalDouble.empty(), false, "test");
    Problems problems = new Problems();
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
                        .formatted(own.spelling(), other.spelling())));
  }

  @Test
  void aHeadLogThatADiskCutShortIsNotedInTheStatus() throws IOException {
    try (Session session = begin("001")) {
      SessionStep step = session.remaining().get(0);
      session.began(step, true);
      session.finished(step, Map.of("head_log_incomplete", true));
    }
    StudyStatus status = StudyStatus.of(material());
    assertThat(status.sessions().get(0).notes()).containsExactly("head log of form incomplete");
    assertThat(status.text()).contains("1 session, 0 finished");
  }

  @Test
  void aFolderThatIsNoSessionIsPassedOver() throws IOException {
    Path stray = folder.resolve("sub-001/ses-99999999999");
    Files.createDirectories(stray);
    Files.writeString(stray.resolve("events.jsonl"), "");
    assertThat(StudyStatus.of(material()).sessions()).isEmpty();
  }

  private CollectedAnswers withPaper(String text, Problems problems) throws IOException {
    Path table = folder.resolve("typed.csv");
    Files.writeString(table, text);
    return CollectedAnswers.of(
        material(),
        OptionalInt.empty(),
        PaperAnswers.read(material(), List.of(table), problems),
        problems);
  }

  @Test
  void answersOnPaperStandForTheScreensThatASessionLacks() throws IOException {
    String own;
    try (Session session = begin("001")) {
      form(session);
      own = session.condition().orElseThrow().spelling();
      answerAll(session, "yes", 4);
      session.abort("recognition-bath");
    }
    Problems problems = new Problems();
    CollectedAnswers collected =
        withPaper(
            """
            participant,condition,area,object,consistency,present,response,confidence
            001,,bath,soap,,,No,2
            """,
            problems);
    assertThat(collected.responses())
        .hasLineCount(4)
        .contains("001," + own + ",bath,soap,consistent,yes,no,2\n");
    assertThat(collected.participants()).isEqualTo(1);
    assertThat(collected.answers()).isEqualTo(3);
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("expectancy-hall were not finished");
  }

  @Test
  void whoAnsweredOnPaperAloneNeedsAConditionTypedIn() throws IOException {
    Problems problems = new Problems();
    CollectedAnswers collected =
        withPaper(
            """
            participant,condition,area,object,consistency,present,response,confidence
            011,selective,hall,coat,consistent,yes,yes,5
            011,selective,hall,boat,inconsistent,no,,
            012,,hall,coat,consistent,yes,yes,5
            012,,hall,boat,consistent,yes,yes,5
            """,
            problems);
    assertThat(collected.responses())
        .contains("011,selective,hall,coat,consistent,yes,yes,5\n")
        .contains("011,selective,hall,boat,inconsistent,no,,\n")
        .hasLineCount(3);
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("typed.csv:4:1: ", "participant 012: participants.tsv assigns no condition");
  }

  @Test
  void aSpreadsheetThatDropsZerosDoesNotMakeAnotherParticipant() throws IOException {
    new Participants(material().study()).assign("001", Optional.empty(), "18-22", false);
    Problems problems = new Problems();
    CollectedAnswers collected =
        withPaper(
            "participant,condition,area,object,response,confidence\n1,high,hall,coat,yes,5\n",
            problems);
    assertThat(collected.participants()).isZero();
    assertThat(problems.list())
        .anyMatch(
            problem ->
                problem.message().contains("there is a participant 001: did a spreadsheet remove"));
  }

  @Test
  void whatIsWrongOnPaperIsSaidWithItsPlaceAndNothingElseIsLost() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
    }
    Problems problems = new Problems();
    CollectedAnswers collected =
        withPaper(
            """
            participant,condition,area,object,response,confidence
            001,,hall,coat,no,1
            002,high,attic,coat,no,1
            002,high,hall,coat,maybe,1
            002,high,hall,boat,no,6
            002,high,hall,boat,,3
            002,high,bath,soap,yes,3
            002,high,bath,soap,no,3
            002,high,hall,hat,no,3
            002,high,hall,coat,no,3
            """,
            problems);
    assertThat(collected.responses())
        .hasLineCount(5)
        .contains("002,high,hall,coat,consistent,yes,no,3\n");
    assertThat(problems.list().stream().map(Problem::toString).toList())
        .anyMatch(line -> line.contains(":2:1: ") && line.contains("in the program"))
        .anyMatch(line -> line.contains(":3:1: ") && line.contains("no screen recognition-attic"))
        .anyMatch(line -> line.contains(":4:20: ") && line.contains("is not yes or no"))
        .anyMatch(line -> line.contains(":5:23: ") && line.contains("not a confidence from 1 to 5"))
        .anyMatch(line -> line.contains(":6:20: ") && line.contains("a confidence but no answer"))
        .anyMatch(line -> line.contains(":8:1: ") && line.contains("both are left out"))
        .anyMatch(line -> line.contains("no longer asks about hat"));
  }

  @Test
  void ratingsOnPaperCountWithTheOthers() throws IOException {
    Problems problems = new Problems();
    Path table = folder.resolve("typed.csv");
    Files.writeString(
        table,
        "participant,area,object,schema,rating\n7,hall,coat,,6\n7,hall,boat,,\n8,hall,coat,,9\n");
    Files.writeString(
        file, Files.readString(file).replace("[\"high\", \"selective\"]", "[\"high\"]"));
    CollectedAnswers collected =
        CollectedAnswers.of(
            material(),
            OptionalInt.empty(),
            PaperAnswers.read(material(), List.of(table), problems),
            problems);
    assertThat(collected.ratings()).contains("7,hall,coat,HallSchema,6\n");
    assertThat(collected.bands()).contains("hall,HallSchema,coat,6.000000,1,");
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("typed.csv:4:14: ", "'9' is not a rating");
  }
}
