package org.selectiverenderer.experiment.questionnaire;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.base.csv.CsvText;

/**
 * Answers and scores as CSV, gathered questionnaire by questionnaire: a row for each question that
 * was asked, in the order of the pages; without an answer, its cell is empty. Not safe for use by
 * several threads.
 */
public final class AnswersCsv {
  private static final String SCORES =
      CsvText.line("participant", "session", "condition", "questionnaire", "score", "value");

  private final Map<AnswerTable, StringBuilder> rows = new EnumMap<>(AnswerTable.class);
  private final StringBuilder scores = new StringBuilder();

  /** Adds the answers to a questionnaire as the participant met it. */
  public void add(AskedBy by, Questionnaire questionnaire, Map<String, GivenAnswer> given) {
    Map<String, Answer> answers = new HashMap<>();
    given.forEach((question, one) -> answers.put(question, one.answer()));
    Map<String, Answer> counting = questionnaire.counting(answers);
    for (TabledAnswer one : questionnaire.tabled(given)) {
      QuestionKind kind = one.question().kind();
      List<Object> cells = kind.row(by, one.page().id(), one.question(), one.given());
      rows.computeIfAbsent(kind.table(), table -> new StringBuilder())
          .append(CsvText.line(cells.toArray()));
    }
    for (ScaleScore score : questionnaire.scores()) {
      score
          .of(questionnaire, counting)
          .ifPresent(
              value ->
                  scores.append(
                      CsvText.line(
                          by.participant(),
                          by.session(),
                          by.condition(),
                          by.questionnaire(),
                          score.name(),
                          tidy(value))));
    }
  }

  /** At most four decimals, none that are zero. */
  private static String tidy(double value) {
    String text = String.format(Locale.ROOT, "%.4f", value);
    return text.replaceFirst("\\.?0+$", "");
  }

  /** Whether a table has rows. */
  public boolean has(AnswerTable table) {
    return rows.containsKey(table);
  }

  /** A table with its header. */
  public String text(AnswerTable table) {
    return table.header() + rows.getOrDefault(table, new StringBuilder());
  }

  /** Whether there are scores. */
  public boolean hasScores() {
    return !scores.isEmpty();
  }

  /** The scores with their header. */
  public String scores() {
    return SCORES + scores;
  }
}
