package org.selectiverenderer.study.questionnaire.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;

/** Scores of the standard scales, by worked examples. */
class StandardScalesTest {
  private static Questionnaire scale(String name) throws IOException {
    return StandardScales.of(name, "en", new ProblemCollector()).orElseThrow();
  }

  private static Map<String, Double> scores(
      Questionnaire scale, Function<String, Integer> answered) {
    Map<String, Answer> answers = new HashMap<>();
    for (Question question : scale.questions()) {
      answers.put(question.id(), Answer.of(Integer.toString(answered.apply(question.id()))));
    }
    Map<String, Double> scores = new LinkedHashMap<>();
    scale.scores().forEach(s -> scores.put(s.name(), s.of(scale, answers).orElse(Double.NaN)));
    return scores;
  }

  private static void are(Map<String, Double> scores, double... expected) {
    assertThat(scores.values()).hasSize(expected.length);
    int at = 0;
    for (double score : scores.values()) {
      assertThat(score).isCloseTo(expected[at++], Offset.offset(1e-9));
    }
  }

  @Test
  void allAreWholeInEnglishAndGreek() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    for (String name : StandardScales.NAMES) {
      Questionnaire english = StandardScales.of(name, "en", problems).orElseThrow();
      Questionnaire greek = StandardScales.of(name, "el", problems).orElseThrow();
      assertThat(greek.questions())
          .extracting(Question::id)
          .isEqualTo(english.questions().stream().map(Question::id).toList());
      assertThat(greek.questions())
          .extracting(Question::text)
          .allMatch(s -> s.matches(".*[α-ω].*"));
    }
    assertThat(problems.list()).isEmpty();
    assertThat(StandardScales.of("ssq", "fr", problems)).as("English, for want of it").isPresent();
  }

  @Test
  void sicknessIsWeightedAsByKennedyAndOthers() throws IOException {
    Questionnaire ssq = scale("ssq");
    assertThat(ssq.questions()).hasSize(16);
    are(scores(ssq, id -> 0), 0, 0, 0, 0);
    // The largest there are: 21 raw points each, and 63 in all.
    are(scores(ssq, id -> 3), 200.34, 159.18, 292.32, 235.62);
    // General discomfort counts for nausea and oculomotor, nausea for nausea and disorientation.
    are(scores(ssq, id -> id.equals("discomfort") ? 1 : 0), 9.54, 7.58, 0, 2 * 3.74);
    are(scores(ssq, id -> id.equals("nausea") ? 2 : 0), 2 * 9.54, 0, 2 * 13.92, 4 * 3.74);
    are(scores(ssq, id -> id.equals("headache") ? 1 : 0), 0, 7.58, 0, 3.74);
  }

  @Test
  void presenceBySlaterUsohAndSteedIsTheCountOfHighAnswersAndTheMean() throws IOException {
    Questionnaire sus = scale("sus");
    assertThat(sus.questions()).hasSize(6);
    are(scores(sus, id -> 5), 0, 5);
    int[] given = {7, 6, 5, 1, 6, 2};
    Map<String, Integer> order = new HashMap<>();
    sus.questions().forEach(question -> order.put(question.id(), given[order.size()]));
    are(scores(sus, order::get), 3, 4.5);
  }

  @Test
  void presenceByIgroupHasMeansOfWhichThreeItemsAreReversed() throws IOException {
    Questionnaire ipq = scale("ipq");
    assertThat(ipq.questions()).hasSize(14);
    are(scores(ipq, id -> 3), 3, 3, 3, 3);
    // With all at 6, the reversed ones are 0: four of five, three of four, three of four.
    are(scores(ipq, id -> 6), 6, 24 / 5.0, 18 / 4.0, 18 / 4.0);
    are(scores(ipq, id -> id.equals("sp2") || id.equals("real1") ? 0 : 6), 6, 6, 4.5, 6);
  }

  @Test
  void aScoreWithAnAnswerMissingIsNone() throws IOException {
    Questionnaire ssq = scale("ssq");
    Map<String, Answer> answers = new HashMap<>();
    ssq.questions().forEach(question -> answers.put(question.id(), Answer.of("1")));
    answers.remove("headache");
    assertThat(ssq.scores().get(0).of(ssq, answers)).as("nausea").isPresent();
    assertThat(ssq.scores().get(1).of(ssq, answers)).as("oculomotor").isEmpty();
    assertThat(ssq.scores().get(3).of(ssq, answers)).as("total").isEmpty();
  }
}
