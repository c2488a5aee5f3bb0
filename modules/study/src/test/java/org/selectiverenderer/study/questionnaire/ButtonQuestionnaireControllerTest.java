package org.selectiverenderer.study.questionnaire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.read.ItemListReader;
import org.selectiverenderer.study.questionnaire.read.QuestionnaireReader;

/** A questionnaire answered by two buttons and a stick. */
class ButtonQuestionnaireControllerTest {
  @TempDir private Path folder;
  private final List<String> told = new ArrayList<>();
  private ParticipantMessages wording;

  @BeforeEach
  void words() throws IOException {
    wording = ParticipantMessages.of("en", folder, new ProblemCollector()).orElseThrow();
  }

  private Questionnaire memory() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("items.csv"),
            """
            area,object,consistency,present,en
            hall,cube,consistent,yes,a cube
            hall,lamp,inconsistent,no,a lamp
            """);
    return ItemListReader.read(
            ItemQuestionnaireKind.RECOGNITION, file, "memory", wording, new ProblemCollector())
        .orElseThrow()
        .get(0);
  }

  private Questionnaire own(String questions) throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("own.json"),
            """
            {"name": "own", "pages": [{"name": "read", "title": "Now", "text": "Read this."},
              {"name": "asked", "questions": [%s]}]}
            """
                .formatted(questions));
    ProblemCollector problems = new ProblemCollector();
    Optional<Questionnaire> read = QuestionnaireReader.read(file, "en", problems);
    assertThat(problems.list()).isEmpty();
    return read.orElseThrow();
  }

  private ButtonQuestionnaireController course(
      Questionnaire questionnaire, Map<String, Answer> known) {
    return new ButtonQuestionnaireController(
        new QuestionnaireProgress(
            questionnaire,
            wording,
            known,
            Optional.empty(),
            new QuestionnaireProgress.Listener() {
              @Override
              public void shown(QuestionnairePage page, List<Question> asked) {
                told.add("page " + page.id() + " " + asked.size());
              }

              @Override
              public void answered(Question question, Answer answer, long ms, int place) {
                assertThat(ms).isNotNegative();
                told.add(place + " " + question.id() + " " + answer.value() + answer.confidence());
              }
            }),
        wording);
  }

  @Test
  void eachButtonAnswersAndTheStickSaysHowSureOneIs() throws IOException {
    ButtonQuestionnaireController asked = course(memory(), Map.of());
    assertThat(asked.oneOfTwo()).isTrue();
    assertThat(asked.marked()).isEmpty();
    asked.yes();
    assertThat(asked.choice().orElseThrow().options()).hasSize(5);
    asked.yes(); // Nothing is marked yet.
    asked.more();
    asked.more();
    asked.yes();
    asked.no();
    asked.less(); // From the other end.
    asked.less();
    asked.yes();
    assertThat(asked.question()).isEmpty();
    assertThat(asked.over()).isFalse();
    asked.yes();
    assertThat(asked.over()).isTrue();
    assertThat(told)
        .containsExactly("page hall 2", "1 cube yes0", "1 cube yes2", "2 lamp no0", "2 lamp no4");
  }

  @Test
  void whatWasAnsweredCanBeLookedAtAndChanged() throws IOException {
    ButtonQuestionnaireController asked =
        course(memory(), Map.of("cube", new Answer("yes", 3), "lamp", new Answer("no", 1)));
    assertThat(asked.question()).isEmpty();
    asked.no();
    assertThat(asked.question().orElseThrow().id()).isEqualTo("cube");
    assertThat(asked.marked()).hasValue(0);
    asked.less();
    assertThat(asked.question().orElseThrow().id()).isEqualTo("lamp");
    asked.more();
    asked.no();
    assertThat(asked.marked()).hasValue(2);
    asked.yes();
    assertThat(told).containsExactly("page hall 2", "1 cube no3", "1 cube no3");
  }

  @Test
  void aQuestionThatIsOpenCannotBePassed() throws IOException {
    ButtonQuestionnaireController asked = course(memory(), Map.of());
    asked.less();
    assertThat(asked.question().orElseThrow().id()).isEqualTo("cube");
  }

  @Test
  void pagesThatAreReadAreTurnedAndScalesAreChosenFrom() throws IOException {
    ButtonQuestionnaireController asked =
        course(
            own(
                """
                {"id": "there", "kind": "scale", "from": 1, "to": 7, "text": "Were you there?"}
                """),
            Map.of());
    asked.no(); // There is no page before the first.
    asked.yes();
    asked.no();
    asked.no();
    asked.no();
    assertThat(asked.marked()).hasValue(2);
    asked.yes();
    asked.yes();
    assertThat(asked.over()).isTrue();
    assertThat(told).containsExactly("page read 0", "page asked 1", "1 there 30");
  }

  private static final String SEVERAL =
      """
      {"id": "which", "kind": "multiple", "text": "Which?",
       "options": [{"value": "a", "text": "A"}, {"value": "b", "text": "B"}]}
      """;

  @Test
  void severalOptionsAreTakenOneByOne() throws IOException {
    ButtonQuestionnaireController asked = course(own(SEVERAL), Map.of());
    asked.yes();
    assertThat(asked.oneOfTwo()).isFalse();
    asked.yes(); // Nothing is marked yet.
    asked.no();
    asked.yes();
    asked.no();
    asked.yes();
    assertThat(asked.chosen(0)).isTrue();
    assertThat(asked.chosen(1)).isTrue();
    asked.choose(0); // Taken back, by pointing.
    assertThat(asked.chosen(0)).isFalse();
    asked.no();
    asked.yes(); // Behind the last option.
    asked.yes();
    assertThat(asked.over()).isTrue();
    assertThat(told)
        .containsExactly("page read 0", "page asked 1", "1 which a0", "1 which a|b0", "1 which b0");
  }

  @Test
  void aWrittenAnswerIsKeptWhenOneGoesOn() throws IOException {
    ButtonQuestionnaireController asked =
        course(
            own(
                """
                {"id": "say", "kind": "text", "text": "Say", "optional": true},
                {"id": "age", "kind": "number", "min": 18, "max": 99, "whole": true, "text": "Age"}
                """),
            Map.of());
    asked.yes();
    assertThat(asked.choice()).isEmpty();
    asked.write("καλά!");
    asked.no();
    assertThat(asked.written()).isEqualTo("καλά");
    asked.yes();
    asked.write("1");
    assertThat(asked.mayGoOn()).isFalse();
    asked.yes();
    assertThat(asked.question().orElseThrow().id()).isEqualTo("age");
    asked.write("9");
    asked.yes();
    assertThat(asked.question()).isEmpty();
    assertThat(told).containsExactly("page read 0", "page asked 2", "1 say καλά0", "2 age 190");
  }

  @Test
  void whatNeedNotBeWrittenMayBeLeftOut() throws IOException {
    ButtonQuestionnaireController asked =
        course(
            own("{\"id\": \"say\", \"kind\": \"text\", \"text\": \"Say\", \"optional\": true}"),
            Map.of("say", new Answer("so", 0)));
    asked.yes();
    asked.back();
    assertThat(asked.written()).isEqualTo("so");
    asked.erase();
    asked.erase();
    asked.erase();
    asked.forward();
    assertThat(asked.question()).isEmpty();
    assertThat(told).last().isEqualTo("1 say 0");
  }

  @Test
  void aSliderIsMovedAndGivenByButtons() throws IOException {
    ButtonQuestionnaireController asked =
        course(
            own(
                """
                {"id": "far", "kind": "slider", "text": "How far?"},
                {"id": "long", "kind": "scale", "from": 0, "to": 20, "text": "How long?"},
                {"id": "set", "kind": "slider", "text": "How warm?", "start": 20}
                """),
            Map.of());
    asked.yes();
    assertThat(asked.thumb()).as("hidden").isEmpty();
    asked.yes();
    assertThat(asked.question().orElseThrow().id()).as("no answer yet").isEqualTo("far");
    asked.more();
    assertThat(asked.thumb()).hasValue(50);
    asked.more();
    asked.no();
    assertThat(asked.thumb()).hasValue(56);
    assertThat(told).as("still moving").hasSize(2);
    asked.yes();
    asked.slide(20);
    asked.no();
    assertThat(asked.thumb()).as("after the right end").hasValue(0);
    asked.yes();
    assertThat(asked.thumb()).as("shown").hasValue(20);
    asked.yes();
    asked.yes();
    assertThat(asked.over()).isTrue();
    assertThat(told)
        .containsExactly("page read 0", "page asked 3", "1 far 560", "2 long 00", "3 set 200");
  }

  @Test
  void aSliderThatIsSimulatedIsAnswered() throws IOException {
    ButtonQuestionnaireController asked =
        course(own("{\"id\": \"far\", \"kind\": \"slider\", \"text\": \"How far?\"}"), Map.of());
    asked.yes();
    assertThat(asked.simulate(new java.util.Random(2))).isTrue();
    asked.yes();
    asked.yes();
    assertThat(asked.over()).isTrue();
    assertThat(told).anyMatch(line -> line.matches("1 far \\d+0"));
  }
}
