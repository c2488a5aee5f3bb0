package org.selectiverenderer.experiment.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.OptionalInt;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problems;

/** Who is done, and what is missing. */
class StudyStatusTest extends TwoRoomsStudy {
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
}
