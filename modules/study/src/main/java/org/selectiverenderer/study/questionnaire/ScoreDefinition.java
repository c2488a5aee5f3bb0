package org.selectiverenderer.study.questionnaire;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * The definition of a score: {@code weight} times the sum, mean or count of the values of some
 * answers.
 *
 * @param questions whose values are taken
 * @param scores other scores whose unweighted values are taken, too
 * @param reversed reverse-coded questions, whose value is taken as {@code from + to - value}
 * @param least for {@link By#COUNT}: the least value that is counted
 */
public record ScoreDefinition(
    String name,
    By by,
    List<String> questions,
    List<String> scores,
    Set<String> reversed,
    double least,
    double weight) {
  public ScoreDefinition {
    questions = List.copyOf(questions);
    scores = List.copyOf(scores);
    reversed = Set.copyOf(reversed);
  }

  /** The function of the values. */
  public enum By {
    SUM,
    MEAN,
    COUNT;

    /** Returns the spelling in files. */
    public String spelling() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /**
   * Computes the score.
   *
   * @param answers the answers that count
   * @return empty if an answer is missing or is not a number: a score of some of the questions
   *     cannot be compared with the others
   */
  public OptionalDouble of(Questionnaire questionnaire, Map<String, Answer> answers) {
    OptionalDouble raw = raw(questionnaire, answers);
    return raw.isPresent() ? OptionalDouble.of(raw.getAsDouble() * weight) : raw;
  }

  private OptionalDouble raw(Questionnaire questionnaire, Map<String, Answer> answers) {
    double[] values = new double[questions.size() + scores.size()];
    int count = 0;
    for (String question : questions) {
      values[count++] = value(questionnaire, question, answers);
    }
    for (String other : scores) {
      values[count++] =
          questionnaire.scores().stream()
              .filter(score -> score.name().equals(other))
              .findFirst()
              .map(score -> score.raw(questionnaire, answers).orElse(Double.NaN))
              .orElse(Double.NaN);
    }
    double sum = 0;
    for (double value : values) {
      sum += by == By.COUNT ? (Double.isNaN(value) ? value : value >= least ? 1 : 0) : value;
    }
    double result = by == By.MEAN ? sum / count : sum;
    return Double.isNaN(result) ? OptionalDouble.empty() : OptionalDouble.of(result);
  }

  private double value(Questionnaire questionnaire, String id, Map<String, Answer> answers) {
    String text = answers.getOrDefault(id, Answer.NONE).value();
    if (!text.matches("-?\\d+(\\.\\d+)?")) {
      return Double.NaN;
    }
    double value = Double.parseDouble(text);
    if (!reversed.contains(id)) {
      return value;
    }
    return questionnaire
        .question(id)
        .map(Question::kind)
        .map(kind -> turned(kind, value))
        .orElse(Double.NaN);
  }

  private static double turned(QuestionKind kind, double value) {
    return kind.scale()
        .map(scale -> scale.from().doubleValue() + scale.to().doubleValue() - value)
        .orElse(Double.NaN);
  }
}
