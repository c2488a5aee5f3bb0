package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.statistics.data.ResponsesCsv;

/** Answers as CSV: those about memory as the statistics read them, ratings as the enricher does. */
public final class AnswersCsv {
  private AnswersCsv() {}

  /** The header of a file of ratings. */
  public static final String RATINGS = "participant,area,object,schema,rating\n";

  /** The header of a file of answers about memory. */
  public static String responsesHeader() {
    return ResponsesCsv.of(List.of());
  }

  /**
   * Answers about memory, a line for each item, without a header; without an answer, that is empty.
   */
  public static String responses(
      Screen screen, String participant, String condition, Function<QuestionItem, Answer> answers) {
    return screen.items().stream()
        .map(
            item -> {
              Answer answer = answers.apply(item);
              return CsvText.line(
                  participant,
                  condition,
                  item.area(),
                  item.object(),
                  item.type(),
                  item.present() ? "yes" : "no",
                  answer.value(),
                  answer.confidence() == 0 ? "" : Integer.toString(answer.confidence()));
            })
        .collect(Collectors.joining());
  }

  /** Ratings, a line for each item but examples, without a header. */
  public static String ratings(
      Screen screen, String participant, Function<QuestionItem, Answer> answers) {
    return screen.items().stream()
        .filter(item -> !item.example())
        .map(
            item ->
                CsvText.line(
                    participant,
                    item.area(),
                    item.object(),
                    item.schema(),
                    answers.apply(item).value()))
        .collect(Collectors.joining());
  }

  /** All of a screen's answers. */
  public static String lines(
      Screen screen, String participant, String condition, Map<String, Answer> byObject) {
    Function<QuestionItem, Answer> answers =
        item -> byObject.getOrDefault(item.object(), Answer.NONE);
    return screen.withConfidence()
        ? responses(screen, participant, condition, answers)
        : ratings(screen, participant, answers);
  }
}
