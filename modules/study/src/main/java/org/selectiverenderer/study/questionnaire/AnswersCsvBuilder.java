package org.selectiverenderer.study.questionnaire;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.csv.SpreadsheetText;

/**
 * Builds the CSV tables of answers and scores, questionnaire by questionnaire: a row for each
 * question that was asked, in the order of the pages, with an empty cell if it was not answered.
 * Not thread-safe.
 */
public final class AnswersCsvBuilder {
  private static final String SCORES =
      CsvWriter.line("participant", "session", "condition", "questionnaire", "score", "value");

  private final Map<AnswerTableKind, StringBuilder> rows = new EnumMap<>(AnswerTableKind.class);
  private final StringBuilder scores = new StringBuilder();

  /** Adds the answers to a questionnaire, whose questions are in the participant's order. */
  public void add(Respondent by, Questionnaire questionnaire, Map<String, TimedAnswer> given) {
    Map<String, Answer> answers = new HashMap<>();
    given.forEach((question, one) -> answers.put(question, one.answer()));
    Map<String, Answer> counting = questionnaire.counting(answers);
    for (AnswerRow one : questionnaire.tabled(given)) {
      QuestionKind kind = one.question().kind();
      List<List<Object>> lines = new ArrayList<>();
      lines.add(kind.row(by, one.page().id(), one.question(), one.given()));
      lines.addAll(kind.further(by, one.page().id(), one.question(), one.given()));
      for (List<Object> cells : lines) {
        rows.computeIfAbsent(kind.table(), table -> new StringBuilder())
            .append(CsvWriter.line(cells.stream().map(AnswersCsvBuilder::cell).toArray()));
      }
    }
    for (ScoreDefinition score : questionnaire.scores()) {
      score
          .of(questionnaire, counting)
          .ifPresent(
              value ->
                  scores.append(
                      CsvWriter.line(
                          by.participant(),
                          by.session(),
                          by.condition(),
                          by.questionnaire(),
                          cell(score.name()),
                          tidy(value))));
    }
  }

  /** Returns a cell as it may be opened in a spreadsheet: answers are others' text. */
  private static Object cell(Object content) {
    return content instanceof String text ? SpreadsheetText.marked(text) : content;
  }

  /** Formats a number with at most four decimals and without trailing zeros. */
  private static String tidy(double value) {
    String text = String.format(Locale.ROOT, "%.4f", value);
    return text.replaceFirst("\\.?0+$", "");
  }

  /** Returns whether a table has rows. */
  public boolean has(AnswerTableKind table) {
    return rows.containsKey(table);
  }

  /** Returns a table with its header. */
  public String text(AnswerTableKind table) {
    return table.header() + rows.getOrDefault(table, new StringBuilder());
  }

  /** Returns whether there are scores. */
  public boolean hasScores() {
    return !scores.isEmpty();
  }

  /** Returns the scores with their header. */
  public String scores() {
    return SCORES + scores;
  }
}
