package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;

/** Answers that were given on paper and typed into a table. */
class PaperAnswersTest extends TwoRoomStudyFixture {
  private CollectedAnswers withPaper(String text, ProblemCollector problems) throws IOException {
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
      own = session.group().orElseThrow().name();
      answerAll(session, "yes", 4);
      session.abort("recognition-bath");
    }
    ProblemCollector problems = new ProblemCollector();
    CollectedAnswers collected =
        withPaper(
            """
            participant,condition,area,object,consistency,present,response,confidence
            001,,bath,soap,,,No,2
            """,
            problems);
    assertThat(collected.responses())
        .hasLineCount(4)
        .contains("001," + own + ",bath,soap,consistent,yes,no,2,,\n");
    assertThat(collected.participants()).isEqualTo(1);
    assertThat(collected.answers()).isEqualTo(3);
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("expectancy-hall were not finished");
  }

  @Test
  void whoAnsweredOnPaperAloneNeedsAConditionTypedIn() throws IOException {
    ProblemCollector problems = new ProblemCollector();
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
        .contains("011,selective,hall,coat,consistent,yes,yes,5,,\n")
        .contains("011,selective,hall,boat,inconsistent,no,,,,\n")
        .hasLineCount(3);
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("typed.csv:4:1: ", "participant 012: participants.tsv assigns no condition");
  }

  @Test
  void aSpreadsheetThatDropsZerosDoesNotMakeAnotherParticipant() throws IOException {
    new ParticipantsFile(material().study()).assign("001", Optional.empty(), "18-22", false);
    ProblemCollector problems = new ProblemCollector();
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
    ProblemCollector problems = new ProblemCollector();
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
        .contains("002,high,hall,coat,consistent,yes,no,3,,\n");
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
    ProblemCollector problems = new ProblemCollector();
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
    assertThat(collected.ratings()).contains("7,hall,coat,HallSchema,6,,\n");
    assertThat(collected.bands()).contains("hall,HallSchema,coat,6.000000,1,");
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("typed.csv:4:14: ", "'9' is not a rating");
  }
}
