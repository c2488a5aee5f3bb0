package org.selectiverenderer.study.questionnaire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.paper.DataEntryTemplate;
import org.selectiverenderer.study.questionnaire.paper.PaperQuestionnaireHtml;
import org.selectiverenderer.study.questionnaire.read.QuestionnaireReader;

/** Options put in order, and statements with one set of options. */
class RankingAndGridTest {
  private static final String ASKED =
      """
      {"name": "own", "pages": [{"order": "random", "questions": [
        {"id": "best", "kind": "ranking", "text": "Which room first?", "order": "random",
         "options": [{"value": "hall", "text": "The hall"}, {"value": "attic", "text": "The attic"},
           {"value": "cellar", "text": "The cellar"}]},
        {"id": "more", "kind": "text", "text": "Why?", "optional": true},
        {"id": "agree", "kind": "grid", "text": "Do you agree?", "rows": [
          {"id": "warm", "text": "It was warm."}, {"id": "large", "text": "It was large."}],
         "options": [{"value": "1", "text": "I do not agree with it at all"},
           {"value": "2", "text": "I neither agree nor disagree"},
           {"value": "3", "text": "I agree with all of it"}]}]}],
       "scores": [{"name": "comfort", "by": "mean", "questions": ["agree_warm", "agree_large"],
         "reversed": ["agree_large"]}]}
      """;

  @TempDir private Path folder;
  private ParticipantMessages wording;
  private Questionnaire asked;

  @BeforeEach
  void read() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    wording = ParticipantMessages.of("en", folder, problems).orElseThrow();
    Path file = Files.writeString(folder.resolve("own.json"), ASKED);
    asked = QuestionnaireReader.read(file, "en", problems).orElseThrow();
    assertThat(problems.list()).isEmpty();
  }

  private RankingField best(Questionnaire of) {
    return (RankingField) of.question("best").orElseThrow().kind().fields(wording).get(0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "hall", "hall|attic", "hall|attic|attic", "hall|attic|cellar|hall"})
  void anOrderOfSomeIsNoAnswer(String text) {
    assertThat(best(asked).typed(text)).isEmpty();
  }

  @Test
  void anOrderIsTypedFromTheFirstToTheLast() {
    RankingField best = best(asked);
    assertThat(best.typed("Cellar | hall|attic")).hasValue("cellar|hall|attic");
    assertThat(best.allowed()).contains("attic|cellar|hall");
    String simulated = best.simulated(new Random(1));
    assertThat(best.typed(simulated)).hasValue(simulated);
  }

  @Test
  void eachParticipantSeesTheOptionsInAnOrderOfTheirOwn() {
    Set<String> orders = new HashSet<>();
    for (int participant = 0; participant < 40; participant++) {
      Questionnaire own = asked.ordered(7, "P" + participant);
      assertThat(own).isEqualTo(asked.ordered(7, "P" + participant));
      orders.add(RankingField.value(best(own).options()));
      List<String> ids = own.questions().stream().map(Question::id).toList();
      assertThat(ids.indexOf("agree_large"))
          .as("the rows of a grid stay together")
          .isEqualTo(ids.indexOf("agree_warm") + 1);
    }
    assertThat(orders).hasSize(6);
  }

  @Test
  void tablesHaveTheRankOfEachOptionAndTheRowsOfTheGrid() {
    AnswersCsvBuilder tables = new AnswersCsvBuilder();
    tables.add(
        new Respondent("001", "1", "high", "own"),
        asked,
        Map.of(
            "best", TimedAnswer.of(Answer.of("cellar|hall|attic")),
            "agree_warm", TimedAnswer.of(Answer.of("3")),
            "agree_large", TimedAnswer.of(Answer.of("1"))));
    assertThat(tables.text(AnswerTableKind.ANSWERS))
        .contains(
            "page-1,best,ranking,cellar|hall|attic,",
            "page-1,best_attic,ranking,3,",
            "page-1,best_cellar,ranking,1,",
            "page-1,best_hall,ranking,2,",
            "page-1,agree_warm,grid,3,",
            "page-1,agree_large,grid,1,");
    assertThat(tables.scores()).as("(3 + (1 + 3 - 1)) / 2").contains("own,comfort,3\n");
  }

  @Test
  void paperHasLinesForRanksAndATableForTheGrid() throws IOException {
    String html = PaperQuestionnaireHtml.html(List.of(asked), wording, "001");
    assertThat(html)
        .contains("<span class=\"line rank\"></span> The attic", "number the options from 1")
        .containsOnlyOnce("Do you agree?")
        .contains("<th>I agree with all of it</th>", "<tr><td>It was warm.</td><td>1</td>");
    assertThat(DataEntryTemplate.text(List.of(asked), wording, "001", "high"))
        .contains("agree_large,grid", "best,ranking", "from the first to the last");
  }

  @Test
  void buttonsRankOptionsOneAfterTheOther() {
    ButtonQuestionnaireController buttons =
        new ButtonQuestionnaireController(
            new QuestionnaireProgress(
                asked,
                wording,
                Map.of(),
                Optional.empty(),
                new QuestionnaireProgress.Listener() {
                  @Override
                  public void shown(QuestionnairePage page, List<Question> questions) {
                    // What is shown is not looked at here.
                  }

                  @Override
                  public void answered(Question question, Answer answer, long ms, int place) {
                    assertThat(ms).isNotNegative();
                  }
                }),
            wording);
    buttons.choose(2);
    buttons.choose(1);
    buttons.choose(2); // Takes the cellar back.
    buttons.choose(0);
    buttons.forward();
    assertThat(buttons.question().orElseThrow().id()).as("two of three").isEqualTo("best");
    assertThat(buttons.rank(1)).hasValue(1);
    assertThat(buttons.rank(2)).isEmpty();
    buttons.less();
    buttons.less();
    assertThat(buttons.marked()).hasValue(2);
    buttons.yes();
    buttons.yes();
    assertThat(buttons.question().orElseThrow().id()).isEqualTo("more");
    assertThat(buttons.course().answers().get("best")).isEqualTo(Answer.of("attic|hall|cellar"));
    buttons.back();
    assertThat(buttons.rank(0)).as("when one comes back").hasValue(2);
  }
}
