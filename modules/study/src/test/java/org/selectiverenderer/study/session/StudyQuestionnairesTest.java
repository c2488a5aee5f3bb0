package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.paper.DataEntryTemplate;
import org.selectiverenderer.study.questionnaire.paper.PaperQuestionnaireHtml;

/**
 * Questionnaires of an author's own in a session: when they are asked, and what becomes of them.
 */
class StudyQuestionnairesTest {
  @TempDir Path folder;
  private Path file = Path.of("");

  @BeforeEach
  void study() throws IOException {
    file = folder.resolve("study.json");
    Files.writeString(
        file,
        """
        {"name": "Own", "conditions": ["high"], "participants": 2, "form": "form.json",
         "questionnaires": [{"file": "own.json", "when": "begin"}, {"template": "sus"},
                            {"kind": "recognition", "items": "r.csv"}]}
        """);
    Files.writeString(
        folder.resolve("r.csv"),
        "area,object,consistency,present,en\nhall,coat,consistent,yes,Coat\n");
    Files.writeString(
        folder.resolve("form.json"),
        """
        {"name": "me", "pages": [{"questions": [
          {"id": "agree", "kind": "yes-no", "must": "yes", "text": "Do you agree?"},
          {"id": "name", "kind": "text", "personal": true, "text": "Name"},
          {"id": "years", "kind": "number", "sets": "age", "text": "Age", "min": 18, "max": 99},
          {"id": "eyes", "kind": "number", "sets": "ipd", "text": "IPD", "min": 45, "max": 80}]}]}
        """);
    Files.writeString(
        folder.resolve("own.json"),
        """
        {"name": "own", "pages": [{"name": "p", "questions": [
          {"id": "changes", "kind": "yes-no", "text": "Did something change?"},
          {"id": "which", "kind": "text", "text": "What?", "optional": true,
           "when": {"question": "changes", "is": ["yes"]}},
          {"id": "seen", "kind": "multiple", "text": "Seen before?", "options": [
            {"value": "hmd", "text": "a display"}, {"value": "cave", "text": "a CAVE"}]}]}]}
        """);
  }

  private LoadedStudy material() throws IOException {
    return LoadedStudy.read(file, new ProblemCollector()).orElseThrow();
  }

  private static void say(Session session, SessionStep step, String id, String value, int ms)
      throws IOException {
    Question question = session.questionnaire(step).question(id).orElseThrow();
    session.answer(step, question, Answer.of(value), OptionalLong.of(ms), 1);
  }

  @Test
  void answersAreKeptWithTheirTimesAndComeIntoTheTablesButForPersonalOnes() throws IOException {
    try (Session session =
        Session.begin(material(), "001", 1, TwoRoomStudyFixture.OPTIONS, new ProblemCollector())) {
      assertThat(TwoRoomStudyFixture.left(session))
          .containsExactly("form", "own", "sus", "recognition-hall");
      SessionStep form = session.remaining().get(0);
      session.began(form, false);
      say(session, form, "agree", "yes", 900);
      say(session, form, "name", "Eva Ntua", 2000);
      say(session, form, "years", "25", 1);
      say(session, form, "eyes", "58.5", 1);
      session.assign("25");
      session.finished(form, Map.of());
      assertThat(session.ipd()).isEqualTo(58.5);
      SessionStep own = session.remaining().get(0);
      session.began(own, false);
      QuestionnairePage page = session.questionnaire(own).pages().get(0);
      session.shown(own, page, page.asked(Map.of()));
      say(session, own, "changes", "yes", 1000);
      say(session, own, "which", "the boat", 2000);
      say(session, own, "seen", "hmd|cave", 3000);
      say(session, own, "changes", "no", 4000);
      session.finished(own, Map.of());
      SessionStep sus = session.remaining().get(0);
      session.began(sus, false);
      for (Question question : session.questionnaire(sus).questions()) {
        say(session, sus, question.id(), "6", 10);
      }
      session.finished(sus, Map.of());
      session.end();
    }
    Path session = folder.resolve("sub-001/ses-01");
    assertThat(session.resolve("answers.csv"))
        .content()
        .startsWith(
            "participant,session,condition,questionnaire,page,question,kind,value,response_ms,"
                + "place\n001,1,high,form,page-1,agree,yes-no,yes,900,1\n")
        .contains("001,1,high,own,p,changes,yes-no,no,4000,1\n")
        .contains("001,1,high,own,p,seen,multiple,hmd|cave,3000,2\n")
        .doesNotContain("Eva", "the boat");
    assertThat(session.resolve("scores.csv"))
        .hasContent(
            "participant,session,condition,questionnaire,score,value\n"
                + "001,1,high,sus,count,6\n001,1,high,sus,mean,6\n");
    assertThat(session.resolve("events.jsonl"))
        .content()
        .contains("\"event\":\"page\",\"step\":\"own\",\"page\":\"p\"")
        .contains("\"questions\":[\"changes\",\"seen\"]", "\"ms\":4000", "Eva Ntua");
    CollectedAnswers collected =
        CollectedAnswers.of(
            material(), OptionalInt.empty(), PaperAnswers.none(), new ProblemCollector());
    assertThat(collected.others()).isEqualTo(Files.readString(session.resolve("answers.csv")));
    assertThat(collected.scores()).isEqualTo(Files.readString(session.resolve("scores.csv")));
  }

  @Test
  void aSessionThatWasCutOffGoesOnAtThePageThatWasShown() throws IOException {
    try (Session session =
        Session.begin(material(), "001", 1, TwoRoomStudyFixture.OPTIONS, new ProblemCollector())) {
      SessionStep own = session.remaining().get(1);
      session.began(own, false);
      QuestionnairePage page = session.questionnaire(own).pages().get(0);
      session.shown(own, page, page.questions());
      say(session, own, "changes", "yes", 1000);
    }
    try (Session session =
        Session.resume(material(), "001", 1, TwoRoomStudyFixture.OPTIONS, new ProblemCollector())) {
      SessionStep own = session.remaining().get(1);
      assertThat(session.lastPage(own)).contains("p");
      assertThat(session.answers(own)).containsOnly(Map.entry("changes", Answer.of("yes")));
    }
  }

  @Test
  void whatWasTypedInFromPaperIsOfAllKinds() throws IOException {
    LoadedStudy material = material();
    List<org.selectiverenderer.study.questionnaire.Questionnaire> asked =
        material.questionnaires("007");
    assertThat(PaperQuestionnaireHtml.html(asked, material.wording(), "007"))
        .contains("Only if you answered to &quot;Did something change?&quot;: Yes")
        .contains("<li><span class=\"box\"></span>a CAVE</li>")
        .contains("<div class=\"line\"></div>");
    String table = DataEntryTemplate.text(asked, material.wording(), "007", "high");
    assertThat(table)
        .startsWith(
            "participant,condition,questionnaire,page,question,kind,value,confidence,allowed\n")
        .contains("007,high,own,p,changes,yes-no,,,yes or no\n")
        .contains("007,high,own,p,seen,multiple,,,of hmd|cave\n")
        .contains("007,high,sus,presence,there,scale,,,1 to 7\n")
        .contains("007,high,recognition-hall,hall,coat,recognition,,,");
    Path typed = folder.resolve("007.csv");
    Files.writeString(
        typed,
        table
            .replace("changes,yes-no,,", "changes,yes-no,YES,")
            .replace("which,text,,", "which,text,the boat,")
            .replace("seen,multiple,,", "seen,multiple,A CAVE|hmd,")
            .replace("there,scale,,", "there,scale,8,")
            .replace("coat,recognition,,", "coat,recognition,no,4")
            .replace(",", ";"));
    ProblemCollector problems = new ProblemCollector();
    CollectedAnswers collected =
        CollectedAnswers.of(
            material,
            OptionalInt.empty(),
            PaperAnswers.read(material, List.of(typed), problems),
            problems);
    assertThat(collected.responses()).endsWith("007,high,hall,coat,consistent,yes,no,4,,\n");
    assertThat(collected.others())
        .contains("007,,high,own,p,changes,yes-no,yes,,\n")
        .contains("007,,high,own,p,which,text,the boat,,\n")
        .contains("007,,high,own,p,seen,multiple,hmd|cave,,\n");
    assertThat(problems.list())
        .extracting(Problem::toString)
        .singleElement()
        .asString()
        .contains("007.csv:5:", "'8' is not an answer; it must be 1 to 7");
  }

  @Test
  void aFormOnPaperCountsBesideASessionThatWasEndedBeforeItsForm() throws IOException {
    LoadedStudy material = material();
    try (Session session =
        Session.begin(material, "007", 1, TwoRoomStudyFixture.OPTIONS, new ProblemCollector())) {
      session.began(session.remaining().get(0), false);
      session.abort("form");
    }
    Path typed = folder.resolve("007.csv");
    Files.writeString(
        typed,
        """
        participant,condition,questionnaire,page,question,kind,value,confidence,allowed
        007,high,form,page-1,years,number,33,,
        007,high,recognition-hall,hall,coat,recognition,no,4,
        """);
    ProblemCollector problems = new ProblemCollector();
    CollectedAnswers collected =
        CollectedAnswers.of(
            material,
            OptionalInt.empty(),
            PaperAnswers.read(material, List.of(typed), problems),
            problems);
    assertThat(collected.others()).contains("007,,high,form,page-1,years,number,33,,\n");
  }

  @Test
  void aPictureThatIsNoneIsFoundBeforeASession() throws IOException {
    Path own = folder.resolve("own.json");
    Files.writeString(
        own, Files.readString(own).replace("\"name\": \"p\"", "\"picture\": \"p.png\""));
    ProblemCollector problems = new ProblemCollector();
    assertThat(LoadedStudy.read(file, problems)).isEmpty();
    Files.writeString(folder.resolve("p.png"), "GIF89a");
    assertThat(LoadedStudy.read(file, problems)).isEmpty();
    Files.write(folder.resolve("p.png"), png(30_000, 30_000));
    assertThat(LoadedStudy.read(file, problems)).isEmpty();
    Files.write(folder.resolve("p.png"), Arrays.copyOf(png(3, 3), 20));
    assertThat(LoadedStudy.read(file, problems)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .satisfiesExactly(
            first -> assertThat(first).contains("own.json:1:", "there is no file 'p.png'"),
            second -> assertThat(second).contains("neither a PNG nor a JPEG"),
            third ->
                assertThat(third)
                    .contains("own.json:1:", "the file 'p.png' has 30000 x 30000 pixels;"),
            fourth -> assertThat(fourth).contains("the file 'p.png' is damaged"));
  }

  /** Returns the beginning of a PNG of a size. */
  private static byte[] png(int width, int height) {
    byte[] header =
        ByteBuffer.allocate(17)
            .put("IHDR".getBytes(StandardCharsets.US_ASCII))
            .putInt(width)
            .putInt(height)
            .put(new byte[] {8, 2, 0, 0, 0})
            .array();
    CRC32 sum = new CRC32();
    sum.update(header);
    return ByteBuffer.allocate(41)
        .put(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'})
        .putInt(13)
        .put(header)
        .putInt((int) sum.getValue())
        .putInt(0)
        .put("IDAT".getBytes(StandardCharsets.US_ASCII))
        .array();
  }

  @Test
  void twoStepsOfOneNameAreAnError() throws IOException {
    Files.writeString(
        file, Files.readString(file).replace("\"sus\"", "\"sus\", \"name\": \"own\""));
    ProblemCollector problems = new ProblemCollector();
    assertThat(LoadedStudy.read(file, problems)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("two steps of a session would have the id own;");
  }

  @Test
  void twoStepsWhoseFilesWouldHaveOneNameAreAnError() throws IOException {
    Files.writeString(
        file, Files.readString(file).replace("\"sus\"", "\"sus\", \"name\": \"o-wn\""));
    ProblemCollector problems = new ProblemCollector();
    assertThat(LoadedStudy.read(file, problems)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("the steps own and o-wn would have the same file names");
  }

  @Test
  void aPageInRandomOrderHasOneOfItsOwnForEachParticipantAndTheSameWhenItComesAgain()
      throws IOException {
    String questions =
        IntStream.rangeClosed(1, 8)
            .mapToObj(
                i -> "{\"id\": \"q%d\", \"kind\": \"yes-no\", \"text\": \"%d?\"}".formatted(i, i))
            .collect(Collectors.joining(",\n"));
    Files.writeString(
        folder.resolve("own.json"),
        "{\"name\": \"own\", \"pages\": [{\"name\": \"p\", \"order\": \"random\", \"questions\": [\n"
            + questions
            + "]}]}");
    SessionStep own = new SessionStep.Questions("own", "");
    Set<List<String>> orders = new HashSet<>();
    for (int i = 1; i <= 10; i++) {
      List<String> ids = ids(material().questionnaire(own, "P" + i));
      assertThat(ids(material().questionnaire(own, "P" + i))).isEqualTo(ids);
      assertThat(ids).containsExactlyInAnyOrder("q1", "q2", "q3", "q4", "q5", "q6", "q7", "q8");
      orders.add(ids);
    }
    assertThat(orders).hasSize(10);
  }

  private static List<String> ids(Questionnaire questionnaire) {
    return questionnaire.questions().stream().map(Question::id).toList();
  }

  @Test
  void theTemplateAsksAllSectionsInBothLanguages() throws IOException {
    Path study = StudyTemplate.write(folder.resolve("new"), Path.of("scenes/apartment.x3d"));
    for (String language : List.of("en", "el")) {
      Files.writeString(
          study, Files.readString(study).replaceFirst("(\"language\": \")..", "$1" + language));
      ProblemCollector problems = new ProblemCollector();
      Optional<LoadedStudy> read = LoadedStudy.read(study, problems);
      assertThat(problems.list()).isEmpty();
      List<String> steps = read.orElseThrow().steps().stream().map(SessionStep::id).toList();
      assertThat(steps)
          .containsSubsequence(
              "form",
              "welcome",
              "practice",
              "apartment",
              "exposure-kitchen",
              "exposure-office",
              "lists",
              "recognition-kitchen",
              "recognition-bookcase",
              "presence",
              "room",
              "closing");
      assertThat(read.get().questionnaires("001").stream().map(each -> each.questions().size()))
          .contains(7, 11);
    }
  }
}
