package org.selectiverenderer.statistics.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.statistics.detection.Response;

class ResponsesReaderTest {
  private static final String HEADER =
      "participant,condition,area,object,consistency,present,response,confidence\n";
  private static final String CUP = "p1,high,kitchen,cup,consistent,yes,yes,4\n";
  private static final String KITE = "p1,high,kitchen,kite,inconsistent,no,no,2\n";

  private final ProblemCollector problems = new ProblemCollector();

  @Test
  void goodAnswersAreReadWithoutAWord() {
    Responses found = parse(HEADER + CUP + KITE);
    assertThat(found.usable())
        .extracting(Response::object, Response::present, Response::yes, Response::confidence)
        .containsExactly(tuple("cup", true, true, 4), tuple("kite", false, false, 2));
    assertThat(problems.list()).isEmpty();
  }

  /** Row 2 is bad: its place and reason; it is flagged in the report, and row 3 is used. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "p1,high,kitchen,cup,consistent,yes,yes,6|2:40: participant p1: '6' is not a confidence from"
            + " 1",
        "p1,high,kitchen,cup,consistent,yes,yes,0|2:40: participant p1: '0' is not a confidence",
        "p1,high,kitchen,cup,consistent,yes,yes,\"3,5\"|2:40: participant p1: '3,5' is not a"
            + " confidence from 1 to 5; the",
        "p1,high,kitchen,cup,consistent,yes,yes,3,5|2:1: the row has 9 values, but "
            + "the header has 8 columns (write numbers with a decimal point",
        "p1,high,kitchen,cup,consistent,yes,,4|2:36: participant p1: no answer to cup; the answer"
            + " is",
        "p1,high,kitchen,cup,consistent,yes,maybe,4|2:36: participant p1: 'maybe' is not yes or no",
        "p1,high,kitchen,cup,consistent,,yes,4|2:32: participant p1: the answer (yes "
            + "or no) is missing",
        "p1,high,kitchen,cup,expected,yes,yes,4|2:21: participant p1: 'expected' is "
            + "not a consistency",
        ",high,kitchen,cup,consistent,yes,yes,4|2:1: the participant is missing",
        "p1,,kitchen,cup,consistent,yes,yes,4|2:4: participant p1: the condition is missing",
      })
  void aBadAnswerIsLeftOutWithItsPlaceAndFlagged(String row, String message) {
    Responses found = parse(HEADER + row + "\n" + KITE);
    assertThat(problems.list().get(0)).asString().startsWith("r.csv:" + message);
    assertThat(found.usable()).extracting(Response::object).containsExactly("kite");
    assertThat(found.exclusions()).isNotEmpty();
    assertThat(found.exclusions().get(0).location().line()).isEqualTo(2);
  }

  @Test
  void anAnswerWithoutConfidenceCountsAmongAll() {
    Responses found = parse(HEADER + "p1,high,kitchen,cup,consistent,yes,yes,\n" + KITE);
    assertThat(found.usable()).hasSize(2);
    assertThat(found.usable().get(0).confidence()).isZero();
    assertThat(found.exclusions()).singleElement().asString().contains("counts among all");
  }

  @Test
  void ofTwoAnswersAlikeOneIsKept() {
    Responses found = parse(HEADER + CUP + KITE + CUP);
    assertThat(found.usable()).hasSize(2);
    assertThat(problems.list())
        .singleElement()
        .asString()
        .isEqualTo(
            "r.csv:4:1: participant p1: a second answer to cup; line 2 has the "
                + "first; it is left out");
  }

  @Test
  void ofTwoAnswersThatDifferNoneIsKept() {
    Responses found = parse(HEADER + CUP + KITE + CUP.replace(",4", ",5"));
    assertThat(found.usable()).extracting(Response::object).containsExactly("kite");
    assertThat(problems.list().get(0)).asString().contains("they differ, so both are left out");
  }

  @Test
  void aParticipantInTwoConditionsIsLeftOut() {
    Responses found =
        parse(HEADER + CUP + KITE.replace("high", "selective") + CUP.replace("p1", "p2"));
    assertThat(found.usable()).extracting(Response::participant).containsExactly("p2");
    assertThat(problems.list())
        .singleElement()
        .asString()
        .isEqualTo(
            "r.csv:3:1: participant p1: is in the condition selective here and in high elsewhere;"
                + " all answers are left out");
  }

  @Test
  void anObjectThatOthersWereAskedForIsFlagged() {
    parse(HEADER + CUP + KITE + CUP.replace("p1", "p2"));
    assertThat(problems.list())
        .singleElement()
        .asString()
        .isEqualTo(
            "r.csv:4:1: participant p2: of the 2 objects of the area kitchen, 1 are not in the file"
                + " (kite); the others count");
  }

  @Test
  void participantsThatTheRosterDoesNotKnowAreLeftOut(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("participants.csv");
    Files.writeString(file, "participant,condition\np1,high\np3,selective\n");
    ParticipantRoster roster = ParticipantRoster.read(file, problems).orElseThrow();
    Responses found =
        ResponsesReader.parse(
                "r.csv",
                HEADER + CUP + KITE + CUP.replace("p1", "px"),
                Optional.of(roster),
                problems)
            .orElseThrow();
    assertThat(found.usable()).extracting(Response::participant).containsOnly("p1");
    assertThat(problems.list())
        .extracting(Object::toString)
        .anyMatch(line -> line.startsWith("r.csv:4:1: participant px: is not in the list"))
        .anyMatch(line -> line.endsWith("participants.csv:3:1: participant p3: has no answers"));
  }

  @Test
  void aFileInAnotherEncodingIsRefusedAtTheByte(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("r.csv");
    Files.write(
        file, (HEADER + CUP + "p1,high,kitchen,caf\u00e9,").getBytes(StandardCharsets.ISO_8859_1));
    assertThat(ResponsesReader.read(file, Optional.empty(), false, problems)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("r.csv:3:20: the file is not UTF-8 text (byte E9");
    Files.write(file, (HEADER + CUP).getBytes(StandardCharsets.UTF_16));
    assertThat(ResponsesReader.read(file, Optional.empty(), false, problems)).isEmpty();
    assertThat(problems.list().get(1)).asString().contains("r.csv:1:1: ", "UTF-16");
  }

  @Test
  void aHeaderThatLacksColumnsIsRefused() {
    assertThat(
            ResponsesReader.parse(
                "r.csv", "participant;condition;area\n", Optional.empty(), problems))
        .isEmpty();
    assertThat(problems.list().get(0))
        .asString()
        .contains("r.csv:1:1: ", "the header lacks object, ");
    assertThat(ResponsesReader.parse("r.csv", "participant,area\n", Optional.empty(), problems))
        .isEmpty();
    assertThat(problems.list().get(1)).asString().contains("the header lacks condition, object");
  }

  @Test
  void aFileWithoutAUsableAnswerIsRefused() {
    assertThat(ResponsesReader.parse("r.csv", HEADER, Optional.empty(), problems)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .asString()
        .isEqualTo("r.csv:1:1: there is no usable answer; nothing is analysed");
  }

  /** A decimal comma and tabs are read as the package of tables says. */
  @ParameterizedTest
  @ValueSource(strings = {",", ";", "\t"})
  void tablesOfAnySeparatorAreRead(String separator) {
    String text = HEADER + CUP + KITE;
    if (separator.equals(";")) {
      text = text.replace(",yes,yes,4", ",yes,yes,4|0");
    }
    Responses found = parse(text.replace(",", separator).replace('|', ','));
    assertThat(found.usable()).extracting(Response::confidence).containsExactly(4, 2);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void anObjectOfTwoKindsIsAnErrorAtItsRareKindAndLeftOut() {
    Responses found =
        parse(
            HEADER
                + CUP
                + KITE
                + CUP.replace("p1", "p2")
                + KITE.replace("p1", "p2")
                + CUP.replace("p1", "p3").replace("consistent", "inconsistent")
                + KITE.replace("p1", "p3"));
    assertThat(problems.list())
        .singleElement()
        .asString()
        .isEqualTo(
            "r.csv:6:21: participant p3: cup (kitchen) is inconsistent here and consistent for 2 of"
                + " 3 participants, first in line 2; all answers to it are left out");
    assertThat(found.usable()).extracting(Response::object).containsOnly("kite").hasSize(3);
    assertThat(found.exclusions()).hasSize(1);
  }

  @Test
  void oneObjectInTwoAreasMayBeOfTwoKinds() {
    parse(HEADER + CUP + CUP.replace("kitchen", "desk").replace("consistent", "inconsistent"));
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void anObjectPresentAndAbsentIsAWarningUnlessThatIsMeant(@TempDir Path folder)
      throws IOException {
    String text = HEADER + CUP + CUP.replace("p1", "p2").replace("yes,yes", "no,yes");
    Responses found = parse(text);
    assertThat(problems.list())
        .singleElement()
        .asString()
        .isEqualTo(
            "r.csv:3:32: participant p2: cup (kitchen) is absent here and present for 1 of 2"
                + " participants, first in line 2; each answer counts as its row says"
                + " (use --counterbalanced if that is intended)");
    assertThat(found.usable()).hasSize(2);
    Path file = folder.resolve("r.csv");
    Files.writeString(file, text);
    ProblemCollector none = new ProblemCollector();
    assertThat(ResponsesReader.read(file, Optional.empty(), true, none)).isPresent();
    assertThat(none.list()).isEmpty();
  }

  @Test
  void aConditionOfAnotherCaseIsAnErrorAtTheSmallerGroup() {
    parse(
        HEADER
            + row("p1", "A")
            + row("p2", "A")
            + row("p3", "a")
            + row("p4", "B")
            + row("p5", "B"));
    assertThat(problems.list())
        .extracting(Object::toString)
        .containsExactly(
            "r.csv:4:4: the condition 'a' (1 participant) looks like 'A' (2, first in line 2); they"
                + " are analysed as two conditions; write both alike if they are one",
            "r.csv:4:4: the condition a has one participant only, so its standard deviation is"
                + " undefined");
  }

  @Test
  void aRareConditionOneLetterAwayIsAWarning() {
    StringBuilder text = new StringBuilder(HEADER);
    for (int i = 0; i < 4; i++) {
      text.append(row("a" + i, "selective")).append(row("b" + i, "group1"));
    }
    parse(text + row("c", "selectve") + row("d1", "group2") + row("d2", "group2"));
    assertThat(problems.list().get(0))
        .asString()
        .startsWith("r.csv:10:3: the condition 'selectve' (1 participant) differs by a letter from")
        .contains("'selective' (4, first in line 2)");
    assertThat(problems.list()).noneMatch(problem -> problem.toString().contains("group"));
  }

  @ParameterizedTest
  @CsvSource({"p1,P1", "p1,p-01", "s 7,s07"})
  void participantsThatLookAlikeAreTold(String one, String other) {
    parse(HEADER + row(one, "high") + row(other, "high"));
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("r.csv:3:1: the participant '" + other + "'", "looks like '" + one + "'");
  }

  @Test
  void theFilesChecksumIsKept(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("r.csv");
    Files.writeString(file, HEADER + CUP);
    DataSource source =
        ResponsesReader.read(file, Optional.empty(), false, problems).orElseThrow().source();
    assertThat(source.name()).isEqualTo("r.csv");
    assertThat(source.sha256()).hasValue(Sha256.of(Files.readAllBytes(file)));
  }

  private static String row(String participant, String condition) {
    return participant + "," + condition + ",kitchen,cup,consistent,yes,yes,4\n";
  }

  private Responses parse(String text) {
    return ResponsesReader.parse("r.csv", text, Optional.empty(), problems).orElseThrow();
  }
}
