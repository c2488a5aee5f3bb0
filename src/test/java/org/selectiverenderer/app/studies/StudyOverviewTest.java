package org.selectiverenderer.app.studies;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.studies.ParticipantCheck.Answer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.SessionOptions;

/** The state of a study, what becomes of ids, and a session followed by its journal. */
class StudyOverviewTest {
  @TempDir Path folder;

  private StudyOverview read(boolean blind) throws IOException {
    return StudyOverview.read(
            SmallStudy.write(folder.resolve("study"), blind), study -> true, new ProblemCollector())
        .orElseThrow();
  }

  private static Session begin(StudyOverview study, String id) throws IOException {
    return Session.begin(
        study.material(),
        id,
        1,
        new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
        new ProblemCollector());
  }

  @Test
  void aNewStudyHasAFirstPlaceAndAFreeId() throws IOException {
    StudyOverview study = read(false);
    assertThat(study.next().orElseThrow().number()).isEqualTo(1);
    assertThat(study.ids().next()).isEqualTo("001");
    assertThat(study.status().sessions()).isEmpty();
    assertThat(study.trials()).isFalse();
    assertThat(study.diskLow()).isFalse();
  }

  @Test
  void aStudyWithErrorsIsNotOpenedAndSaysWhy() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    Path file = SmallStudy.write(folder);
    Files.delete(folder.resolve("items.csv"));
    assertThat(StudyOverview.read(file, study -> true, problems)).isEmpty();
    assertThat(problems.anyError()).isTrue();
  }

  @Test
  void conditionsOfABlindStudyAreHiddenUnlessAskedFor() throws IOException {
    StudyOverview study = read(true);
    assertThat(study.blind()).isTrue();
    assertThat(study.status(false).groups()).hasSize(1);
    assertThat(study.status(true).groups()).hasSize(2);
  }

  @Test
  void idsAreJudgedAsTheCommandDoes() throws IOException {
    StudyOverview before = read(false);
    assertThat(ParticipantCheck.of(before, "", 1).answer()).isEqualTo(Answer.EMPTY);
    assertThat(ParticipantCheck.of(before, "a b", 1).answer()).isEqualTo(Answer.INVALID);
    assertThat(ParticipantCheck.of(before, "p01", 1).answer()).isEqualTo(Answer.NEW);
    try (Session session = begin(before, "p01")) {
      StudyOverview running = before.again();
      assertThat(running.runs()).containsExactly(session.folder());
      assertThat(ParticipantCheck.of(running, "p01", 1).answer()).isEqualTo(Answer.RUNNING);
    }
    StudyOverview after = before.again();
    assertThat(after.runs()).isEmpty();
    assertThat(ParticipantCheck.of(after, "p01", 1).answer()).isEqualTo(Answer.BEGUN);
    assertThat(ParticipantCheck.of(after, "p01", 2).answer()).isEqualTo(Answer.KNOWN);
    assertThat(ParticipantCheck.of(after, "1", 1))
        .isEqualTo(new ParticipantCheck(Answer.ALIKE, "p01"));
    assertThat(ParticipantCheck.of(after, "P01", 1))
        .isEqualTo(new ParticipantCheck(Answer.SAME_FOLDER, "p01"));
    assertThat(ParticipantCheck.of(after, "P01", 1).possible()).isFalse();
  }

  @Test
  void aSessionIsFollowedByItsJournal() throws IOException {
    StudyOverview study = read(false);
    Path journal = new SessionFolder(study.study().folder(), "001", 1).journal();
    try (Session session = begin(study, "001")) {
      session.began(session.remaining().get(0), false);
      session.assign("");
      session.finished(session.remaining().get(0), Map.of());
      session.began(session.remaining().get(0), false);
      SessionProgress progress = SessionProgress.read(study.material(), journal);
      assertThat(progress.state()).isEqualTo(SessionProgress.State.BEGUN);
      assertThat(progress.done()).isEqualTo(1);
      assertThat(progress.now().orElseThrow().id()).isEqualTo(session.remaining().get(0).id());
      assertThat(progress.since()).isPresent();
      session.journal().tell("paused", Map.of());
      session.journal().keep("note", Map.of("text", "a phone rang"));
      assertThat(SessionProgress.read(study.material(), journal).paused()).isTrue();
      assertThat(SessionProgress.read(study.material(), journal).notes())
          .containsExactly("a phone rang");
      session.abort();
    }
    SessionProgress ended = SessionProgress.read(study.material(), journal);
    assertThat(ended.state()).isEqualTo(SessionProgress.State.ABORTED);
    assertThat(ended.now()).isEmpty();
  }
}
