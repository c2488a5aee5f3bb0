package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.RatingBand;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.data.ResponsesReader;
import org.selectiverenderer.study.definition.SessionFlag;

/** What the sessions of a study come to. */
class CollectedAnswersTest extends TwoRoomStudyFixture {
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
    ProblemCollector problems = new ProblemCollector();
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
    assertThat(ratings.means().get("coat").get("HallSchema").band())
        .isEqualTo(RatingBand.NON_EXPECTANT);
    assertThat(collected.bands())
        .contains("hall,HallSchema,coat,2.000000,1,non-expectant,inconsistent");
    assertThat(problems.list()).isEmpty();
  }

  private List<String> collecting(OptionalInt session, int lines) throws IOException {
    ProblemCollector problems = new ProblemCollector();
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
    try (Session session = Session.begin(material(), "001", 2, OPTIONS, new ProblemCollector())) {
      form(session);
      answerAll(session, "yes", 4);
      answerAll(session, "yes", 4);
      answerAll(session, "2", 0);
    }
    assertThat(collecting(OptionalInt.empty(), 4))
        .singleElement()
        .asString()
        .contains(Path.of("ses-01/events.jsonl") + ": ")
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

  private static final String RATINGS_BUT_THE_EXAMPLE =
      "participant,area,object,schema,rating,response_ms,place\n001,hall,coat,HallSchema,2,1000,1\n";

  @Test
  void ratingsOfAnExampleCountNowhere() throws IOException {
    Files.writeString(
        folder.resolve("e.csv"),
        "area,schema,object,en\nshop,example,bed,Bed\nhall,HallSchema,coat,Coat\n");
    try (Session session = begin("001")) {
      form(session);
      answerAll(session, "yes", 4);
      answerAll(session, "yes", 4);
      answerAll(session, "6", 0);
      answerAll(session, "2", 0);
      session.end();
    }

    ProblemCollector problems = new ProblemCollector();
    CollectedAnswers collected =
        CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), problems);

    assertThat(problems.list()).isEmpty();
    assertThat(collected.ratings()).isEqualTo(RATINGS_BUT_THE_EXAMPLE);
    assertThat(collected.bands()).contains("hall").doesNotContain("bed");
    assertThat(collected.answers()).isEqualTo(4);
    assertThat(folder.resolve("sub-001/ses-01/ratings.csv")).hasContent(RATINGS_BUT_THE_EXAMPLE);
  }

  @Test
  void aParticipantWithAConditionAndNoSessionIsSaidToBeMissing() throws IOException {
    new ParticipantsFile(material().study()).assign("009", Optional.empty(), "18-22", false);
    assertThat(collecting(OptionalInt.empty(), 1))
        .singleElement()
        .asString()
        .contains("participants.tsv: ", "the participant 009 has no session;");
  }

  private void whole(String id, SessionFlag... flags) throws IOException {
    whole(id, 1, flags);
  }

  private void whole(String id, int number, SessionFlag... flags) throws IOException {
    try (Session session = Session.begin(material(), id, number, OPTIONS, new ProblemCollector())) {
      form(session);
      for (SessionFlag flag : flags) {
        session.journal().flag(flag, Map.of("step", "exposure-hall"));
      }
      answerAll(session, "yes", 4);
      answerAll(session, "no", 1);
      answerAll(session, "2", 0);
      session.end();
    }
  }

  @Test
  void aFlaggedSessionIsSaidAndKeptUnlessTheStudyExcludesIt() throws IOException {
    whole("001", SessionFlag.REPEATED_EXPOSURE, SessionFlag.LOW_FRAME_RATE);
    whole("002");
    ProblemCollector kept = new ProblemCollector();
    assertThat(
            CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), kept)
                .participants())
        .isEqualTo(2);
    assertThat(kept.any()).isFalse();
    assertThat(kept.list())
        .extracting(Problem::message)
        .containsExactly(
            "the session is flagged repeated-exposure (exposure-hall); the answers are kept, as the"
                + " study does not exclude it",
            "the session is flagged low-frame-rate (exposure-hall); the answers are kept, as the"
                + " study does not exclude it");

    exclude("repeated-exposure", "low-frame-rate", "simulated");
    ProblemCollector excluded = new ProblemCollector();
    CollectedAnswers answers =
        CollectedAnswers.of(material(), OptionalInt.empty(), PaperAnswers.none(), excluded);
    assertThat(answers.participants()).isEqualTo(1);
    assertThat(answers.responses()).doesNotContain("001,").hasLineCount(4);
    assertThat(answers.ratings()).doesNotContain("001");
    assertThat(excluded.any()).isTrue();
    assertThat(excluded.list())
        .singleElement()
        .asString()
        .isEqualTo(
            folder.resolve("sub-001/ses-01/events.jsonl")
                + ": 5 answers of session 1 of the participant 001 are left out, because the study"
                + " excludes sessions flagged repeated-exposure (exposure-hall), low-frame-rate"
                + " (exposure-hall)");
  }

  @Test
  void aSessionThatTheStudyDoesNotExcludeIsTakenInstead() throws IOException {
    exclude("tracker-lost");
    whole("001", 1, SessionFlag.TRACKER_LOST);
    whole("001", 2);
    assertThat(collecting(OptionalInt.empty(), 4))
        .singleElement()
        .asString()
        .contains("5 answers of session 1 of the participant 001 are left out, because session 2");
    assertThat(collecting(OptionalInt.of(1), 1))
        .anyMatch(line -> line.contains("the study excludes sessions flagged tracker-lost"));
  }
}
