package org.selectiverenderer.study.questionnaire.read;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.QuestionKind;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.TimedAnswer;

class QuestionnaireReaderTest {
  private static final String TEXT =
      """
      {"name": "all", "title": {"en": "All", "el": "Όλα"}, "pages": [
        {"name": "one", "text": "Hello.", "questions": [
          {"id": "scale", "kind": "scale", "to": 3, "text": "How?", "steps": {"en": ["a", "b", "c"]}},
          {"id": "poles", "kind": "bipolar", "left": "dark", "right": "bright"},
          {"id": "yes", "kind": "yes-no", "text": "Really?", "must": "yes"},
          {"id": "single", "kind": "single", "text": "Which?", "options": [
            {"value": "a", "text": {"en": "A", "el": "Α"}}, {"value": "b", "text": "B"}]},
          {"id": "several", "kind": "multiple", "text": "Which?", "options": [
            {"value": "a", "text": "A"}, {"value": "b", "text": "B"}]},
          {"id": "text", "kind": "text", "text": "What?", "lines": 3, "optional": true},
          {"id": "number", "kind": "number", "text": "How many?", "min": 1, "max": 9, "whole": true},
          {"id": "line", "kind": "slider", "text": "How far?", "from": -1, "to": 1, "step": 0.1,
           "least": "near", "most": "far", "marks": true, "number": true, "start": 0.5},
          {"id": "best", "kind": "ranking", "text": "Which first?", "order": "random", "options": [
            {"value": "a", "text": "A"}, {"value": "b", "text": "B"}]},
          {"id": "agree", "kind": "grid", "text": "Do you agree?", "options": [
            {"value": "1", "text": "no"}, {"value": "2", "text": "yes"}], "rows": [
            {"id": "warm", "text": "It was warm."}, {"id": "large", "text": "It was large."}]}]},
        {"name": "two", "when": {"question": "yes", "is": ["yes"]}, "questions": [
          {"id": "why", "kind": "text", "text": "Why?", "when": {"question": "single", "is": ["b"]}}]},
        {"name": "three", "text": "Thank you."}],
       "scores": [{"name": "sum", "questions": ["scale", "poles"], "reversed": ["poles"]}]}
      """;

  private static Optional<Questionnaire> read(String text, ProblemCollector problems) {
    return QuestionnaireReader.parse("all.json", text, "en", problems);
  }

  private static Questionnaire whole() {
    return read(TEXT, new ProblemCollector()).orElseThrow();
  }

  private static Map<String, Answer> answers(String... pairs) {
    Map<String, Answer> answers = new HashMap<>();
    for (int i = 0; i < pairs.length; i += 2) {
      answers.put(pairs[i], Answer.of(pairs[i + 1]));
    }
    return answers;
  }

  @Test
  void aTableHasThePlacesOfTheEndWhenAnAnswerHasOpenedAQuestionBeforeOthers() {
    Questionnaire questionnaire =
        read(
                """
                {"name": "all", "title": "All", "pages": [{"name": "one", "questions": [
                  {"id": "seen", "kind": "yes-no", "text": "Seen?"},
                  {"id": "where", "kind": "text", "text": "Where?",
                   "when": {"question": "seen", "is": ["yes"]}},
                  {"id": "liked", "kind": "yes-no", "text": "Liked?"},
                  {"id": "paper", "kind": "yes-no", "text": "On paper?"}]}]}
                """,
                new ProblemCollector())
            .orElseThrow();
    Map<String, TimedAnswer> given =
        Map.of(
            "liked", TimedAnswer.NONE.then(Answer.of("yes"), OptionalLong.of(100), 2),
            "seen", TimedAnswer.NONE.then(Answer.of("yes"), OptionalLong.of(200), 1),
            "where", TimedAnswer.NONE.then(Answer.of("there"), OptionalLong.of(300), 2),
            "paper", TimedAnswer.of(Answer.of("no")));
    assertThat(questionnaire.tabled(given))
        .extracting(row -> row.question().id() + " " + row.given().placeCell())
        .containsExactly("seen 1", "where 2", "liked 3", "paper ");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"kind\": \"text\"",
        "\"kind\": \"yes-no\"",
        "\"kind\": \"number\", \"max\": 80, \"min\": -1",
        "\"kind\": \"number\", \"min\": 45"
      })
  void whatIsNoDistanceOfPupilsCannotSetIt(String kind) {
    ProblemCollector problems = new ProblemCollector();
    String text =
        "{\"name\": \"me\", \"pages\": [{\"questions\": [\n"
            + " {\"id\": \"eyes\", \"text\": \"IPD\", \"sets\": \"ipd\", %s}]}]}".formatted(kind);
    assertThat(read(text, problems)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .singleElement()
        .asString()
        .startsWith("all.json:2:")
        .contains("\"min\" and \"max\" from 0 to 100");
  }

  @Test
  void aValueThatNoAnswerCanHaveIsAnError() {
    ProblemCollector problems = new ProblemCollector();
    String wrong =
        TEXT.replace("\"must\": \"yes\"", "\"must\": \"Yes\"")
            .replace("\"is\": [\"b\"]", "\"is\": [\"b\", \"B\"]");
    assertThat(read(wrong, problems)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .satisfiesExactly(
            must ->
                assertThat(must)
                    .startsWith("all.json:5:")
                    .contains("'Yes' is not a possible answer; possible are yes, no"),
            when ->
                assertThat(when)
                    .startsWith("all.json:20:")
                    .contains("'B' is not a possible answer; possible are a, b"));
  }

  @Test
  void allKindsAreReadInTheStudysLanguage() {
    Questionnaire read = whole();
    assertThat(read.questions())
        .extracting(question -> question.kind().spelling())
        .containsExactlyElementsOf(
            List.of(
                "scale",
                "bipolar",
                "yes-no",
                "single",
                "multiple",
                "text",
                "number",
                "slider",
                "ranking",
                "grid",
                "grid",
                "text"));
    assertThat(read.questions().stream().map(question -> question.kind().spelling()))
        .containsAll(QuestionKind.IN_FILES);
    Questionnaire greek =
        QuestionnaireReader.parse(
                "all.json",
                TEXT.replace("{\"en\": [\"a\", \"b\", \"c\"]}", "[\"a\", \"b\", \"c\"]"),
                "el",
                new ProblemCollector())
            .orElseThrow();
    assertThat(greek.pages().get(0).title()).isEqualTo("Όλα");
  }

  @Test
  void pagesAndQuestionsDependOnAnswersThatCount() {
    Questionnaire read = whole();
    assertThat(read.shown(answers()))
        .extracting(QuestionnairePage::id)
        .containsExactly("one", "three");
    Map<String, Answer> all = answers("yes", "yes", "single", "b", "why", "so");
    assertThat(read.shown(all))
        .extracting(QuestionnairePage::id)
        .containsExactly("one", "two", "three");
    assertThat(read.pages().get(1).asked(all)).extracting(Question::id).containsExactly("why");
    assertThat(read.counting(all)).containsKey("why");
    all.put("single", Answer.of("a"));
    assertThat(read.counting(all)).as("no longer asked").doesNotContainKey("why");
    assertThat(read.refused(answers("yes", "no"))).isTrue();
    assertThat(read.refused(answers("yes", "yes"))).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "\"kind\": \"bipolar\" | \"kind\": \"bipolr\" | no kind of question 'bipolr'; did you "
            + "mean 'bipolar'?",
        "\"to\": 3 | \"to\": 1 | a scale must have 2 to 101 steps; this one goes from 1 to 1",
        "\"to\": 3 | \"to\": 4 | there are 3 names for the 4 steps",
        "\"to\": 3 | \"to\": 102 | a scale must have 2 to 101 steps",
        "\"step\": 0.1 | \"step\": 0.3 | from -1.0 to 1.0 cannot be divided into steps of 0.3",
        "\"step\": 0.1 | \"step\": 0.0001 | a slider has at most 10000 steps",
        "\"to\": 1, \"step\" | \"to\": -1, \"step\" | \"to\" must be above \"from\"",
        "\"start\": 0.5 | \"start\": 0.55 | a value of the slider, -1 to 1 in steps of 0.1",
        "\"start\": 0.5 | \"start\": \"hiden\" | \"start\" must be \"hidden\" or a value",
        "\"id\": \"large\" | \"id\": \"warm\" | the row warm is defined twice",
        "\"id\": \"large\" | \"id\": \"lar ge\" | a row's id must consist of letters",
        "\"rows\": | \"rws\": | a grid needs 1 to 100 \"rows\"",
        "\"kind\": \"grid\" | \"kind\": \"grid\", \"must\": \"2\" | neither \"must\" nor \"sets\"",
        "\"id\": \"poles\" | \"id\": \"agree_warm\" | the question agree_warm is defined twice",
        "\"id\": \"poles\" | \"id\": \"best_b\" | the question best_b is defined twice",
        "\"order\": \"random\" | \"order\": \"rnd\" | 'rnd' is not one of fixed, random",
        "{\"value\": \"b\", \"text\": \"B\"}]}, | {\"value\": \"b\", \"text\": \"B\", \"picture\": \"b.gif\"}]}, | "
            + "a picture must be a PNG or JPEG file",
        "{\"value\": \"b\", \"text\": \"B\"}]}, | {\"value\": \"b\", \"text\": \"B\", \"picture\": \"b.png\"}]}, | "
            + "there is no file 'b.png'",
        "\"left\": | \"lft\": | a question needs \"left\"",
        "\"id\": \"poles\" | \"id\": \"scale\" | the question scale is defined twice",
        "\"id\": \"poles\" | \"id\": \"my poles\" | a question's id must consist of letters",
        "\"lines\": 3 | \"lins\": 3 | a question has no \"lins\"; did you mean \"lines\"?",
        "\"question\": \"single\" | \"question\": \"singl\" | no earlier question 'singl'; did "
            + "you mean 'single'?",
        "\"max\": 9 | \"max\": 1 | \"max\" must be above \"min\"",
        "{\"value\": \"b\", \"text\": | {\"value\": \"a\", \"text\": | the value a occurs twice",
        "\"text\": \"Thank you.\" | \"order\": \"fixed\" | a page needs a \"text\"",
        "\"optional\": true | \"optional\": 1 | \"optional\" must be true or false",
        "{\"en\": \"All\", | {\"fr\": \"Tout\", | has no text in the study's language 'en', only "
            + "in fr, el",
        "\"reversed\": [\"poles\"] | \"reversed\": [\"text\"] | \"reversed\" names 'text'",
        "\"questions\": [\"scale\", \"poles\"] | \"questions\": [\"scal\", \"poles\"] | names "
            + "'scal', which does not exist; did you mean 'scale'?",
      })
  void whatCannotBeIsAnErrorWithItsPlace(String old, String other, String message) {
    assertThat(TEXT).contains(old);
    ProblemCollector problems = new ProblemCollector();
    assertThat(read(TEXT.replace(old, other), problems)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .allMatch(line -> line.matches("(?s)all\\.json:\\d+:\\d+: .*"))
        .anyMatch(line -> line.contains(message));
  }

  @Test
  void thePublishedSchemaHasTheKeysOfTheReader() throws IOException {
    JsonNode schema =
        new ObjectMapper()
            .readTree(
                Objects.requireNonNull(
                    StudyTemplate.class.getResourceAsStream("questionnaire.schema.json")));
    assertThat(keys(schema)).isEqualTo(known(TEXT.replaceFirst("\\{", "{\"x\": 1, ")));
    assertThat(keys(schema.at("/$defs/page")))
        .isEqualTo(known(TEXT.replace("{\"name\": \"one\"", "{\"x\": 1, \"name\": \"one\"")));
    assertThat(keys(schema.at("/$defs/score")))
        .isEqualTo(known(TEXT.replace("{\"name\": \"sum\"", "{\"x\": 1, \"name\": \"sum\"")));
    List<String> ofQuestions = new ArrayList<>();
    for (String id :
        List.of(
            "scale", "poles", "yes", "single", "several", "text", "number", "line", "best",
            "agree")) {
      ofQuestions.addAll(known(TEXT.replace("{\"id\": \"" + id, "{\"x\": 1, \"id\": \"" + id)));
    }
    assertThat(keys(schema.at("/$defs/question")))
        .isEqualTo(ofQuestions.stream().distinct().sorted().toList());
  }

  private static List<String> keys(JsonNode schema) {
    assertThat(schema.path("additionalProperties").asBoolean(true)).isFalse();
    List<String> keys = new ArrayList<>();
    schema.get("properties").fieldNames().forEachRemaining(keys::add);
    return keys.stream().sorted().toList();
  }

  /** The keys that the reader lists when it meets an unknown one. */
  private static List<String> known(String text) {
    ProblemCollector problems = new ProblemCollector();
    read(text, problems);
    Matcher listed =
        Pattern.compile("has no \"x\" \\(known keys: ([^)]*)\\)")
            .matcher(String.join("\n", problems.list().stream().map(Problem::toString).toList()));
    assertThat(listed.find()).isTrue();
    return List.of(listed.group(1).split(", "));
  }
}
