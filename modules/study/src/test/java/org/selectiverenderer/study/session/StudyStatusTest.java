package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.OptionalInt;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.definition.SessionFlag;

/** Who is done, and what is missing. */
class StudyStatusTest extends TwoRoomStudyFixture {
  @Test
  void statusTellsWhoIsDoneAndWhatIsMissing() throws IOException {
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
      session.abort("recognition-bath");
    }
    begin("002").close();
    StudyStatus status = StudyStatus.of(material(), new ProblemCollector());
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
    ProblemCollector problems = new ProblemCollector();
    assertThat(
            CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), problems)
                .responses())
        .hasLineCount(3);
    assertThat(problems.list()).isNotEmpty();
    assertThat(ParticipantIds.of(material().study()).next()).isEqualTo("003");
  }

  @Test
  void aHeadLogThatADiskCutShortIsNotedInTheStatus() throws IOException {
    try (Session session = begin("001")) {
      SessionStep step = session.remaining().get(0);
      session.began(step, true);
      session.finished(step, Map.of("head_log_incomplete", true));
    }
    StudyStatus status = StudyStatus.of(material(), new ProblemCollector());
    assertThat(status.sessions().get(0).notes()).containsExactly("head log of form incomplete");
    assertThat(status.text()).contains("1 session, 0 finished");
  }

  @Test
  void flagsAreShownAsTextAndAsJsonWithTheirSteps() throws IOException {
    try (Session session = begin("001")) {
      session.journal().flag(SessionFlag.LOW_FRAME_RATE, Map.of("step", "exposure-hall", "fps", 9));
      session.journal().flag(SessionFlag.TRACKER_ABSENT, Map.of());
    }
    StudyStatus status = StudyStatus.of(material(), new ProblemCollector());
    assertThat(status.text())
        .contains("(exposure-hall: too few frames per second, without the study's tracker)")
        .doesNotContain("LEFT OUT");
    JsonNode row = JsonTree.parse(status.json()).path("sessions").path(0);
    assertThat(row.path("flags").toString())
        .isEqualTo(
            "[{\"flag\":\"low-frame-rate\",\"step\":\"exposure-hall\"},"
                + "{\"flag\":\"tracker-absent\",\"step\":\"\"}]");
    assertThat(row.path("excluded").isBoolean()).isTrue();
    assertThat(row.path("excluded").asBoolean()).isFalse();
  }

  @Test
  void aSessionThatTheStudyExcludesDoesNotCountInItsGroup() throws IOException {
    exclude("tracker-absent");
    try (Session session = begin("001")) {
      form(session);
      session.journal().flag(SessionFlag.TRACKER_ABSENT, Map.of());
      answerAll(session, "yes", 4);
      answerAll(session, "yes", 4);
      answerAll(session, "3", 0);
      session.end();
    }
    StudyStatus status = StudyStatus.of(material(), new ProblemCollector());
    assertThat(status.groups()).extracting(StudyStatus.Group::finished).containsOnlyOnce(1);
    assertThat(status.groups()).extracting(StudyStatus.Group::counting).containsOnly(0);
    assertThat(status.text())
        .contains("1 is left out of the answers, as the study excludes it")
        .contains("nothing LEFT OUT (without the study's tracker)");
    assertThat(status.json()).contains("\"excluded\" : true");
  }

  @Test
  void aDamagedLineIsToldByItsNumber() throws IOException {
    begin("001").close();
    Path events = folder.resolve("sub-001/ses-01/events.jsonl");
    Files.writeString(events, "{\"event\":\"no\n" + Files.readString(events) + "{\"event\":\"ha");
    ProblemCollector problems = new ProblemCollector();
    StudyStatus.of(material(), problems);
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly(
            events
                + ":1:1: this line is damaged and is ignored; the other lines are used, and nothing"
                + " is deleted",
            events
                + ":3:1: the last line is cut off, by a crash or because it is being written now; it"
                + " is ignored, and --resume repairs the file");
    assertThat(problems.list())
        .extracting(Problem::severity)
        .containsExactly(Problem.Severity.WARNING, Problem.Severity.INFO);
  }

  @Test
  void aFolderThatIsNoSessionIsPassedOver() throws IOException {
    Path stray = folder.resolve("sub-001/ses-99999999999");
    Files.createDirectories(stray);
    Files.writeString(stray.resolve("events.jsonl"), "");
    assertThat(StudyStatus.of(material(), new ProblemCollector()).sessions()).isEmpty();
  }

  @Test
  void theExperimenterOfABlindStudySeesNoConditions() throws IOException {
    try (Session session = begin("001")) {
      form(session);
    }
    StudyStatus status = StudyStatus.of(material(), new ProblemCollector());
    assertThat(status.text()).containsPattern("high|selective");
    StudyStatus blinded = status.blinded();
    assertThat(blinded.text() + blinded.json())
        .contains("hidden")
        .doesNotContain("high", "selective");
    assertThat(blinded.groups()).containsExactly(new StudyStatus.Group("all", 4, 1, 0, 0));
  }
}
