package org.selectiverenderer.study.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.csv.SpreadsheetText;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialColumns;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.TimedAnswer;

/**
 * A table of trials as CSV in long form: a row for each finished trial, with a column for each
 * factor, each column of the stimuli, the response, and each question that trials ask. A cell
 * without a value is empty.
 */
final class TrialsTable {
  private final LoadedStudy material;
  private final boolean practice;
  private final List<String> factors;
  private final Set<String> stimuli;
  private final Map<String, List<Question>> questions;
  private final List<List<Object>> rows = new ArrayList<>();

  /**
   * @param practice whether trials of practice blocks are rows, too
   */
  TrialsTable(LoadedStudy material, boolean practice) {
    this.material = material;
    this.practice = practice;
    factors = material.study().design().factorNames();
    stimuli = material.study().design().stimulusColumns();
    questions = material.questionsInTrials();
  }

  /** Adds the finished trials of a session, in order. */
  void add(String participant, int session, SessionHistory history) {
    for (TrialResult result : history.results()) {
      Optional<TrialBlock> block =
          material.study().design().blocks().stream()
              .filter(known -> known.name().equals(result.block()))
              .findFirst();
      if (practice || block.flatMap(TrialBlock::practice).isEmpty()) {
        rows.add(row(participant, session, history, result, block));
      }
    }
  }

  private static Map<String, String> listed(Optional<TrialBlock> block, int line) {
    return block
        .flatMap(TrialBlock::stimuli)
        .flatMap(
            list -> list.rows().stream().filter(stimulus -> stimulus.line() == line).findFirst())
        .map(StimulusList.Stimulus::cells)
        .orElse(Map.of());
  }

  private List<Object> row(
      String participant,
      int session,
      SessionHistory history,
      TrialResult result,
      Optional<TrialBlock> block) {
    List<Object> row = new ArrayList<>();
    row.add(participant);
    row.add(session);
    row.add(history.group().orElse(""));
    row.add(result.block());
    row.add(result.number());
    row.add(result.round());
    factors.forEach(factor -> row.add(result.levels().getOrDefault(factor, "")));
    // The cells that the participant has seen count, also where the list has changed since.
    Map<String, String> cells =
        result.stimulus().isEmpty() ? listed(block, result.line()) : result.stimulus();
    stimuli.forEach(column -> row.add(SpreadsheetText.marked(cells.getOrDefault(column, ""))));
    row.add(result.response());
    row.add(
        result.milliseconds().isPresent()
            ? String.format(Locale.ROOT, "%.1f", result.milliseconds().getAsDouble())
            : "");
    row.add(result.correct().map(correct -> correct ? "yes" : "no").orElse(""));
    Map<String, TimedAnswer> given = history.given(result.trial());
    questions
        .values()
        .forEach(
            asked ->
                asked.forEach(
                    question -> {
                      String value =
                          Optional.ofNullable(given.get(question.id()))
                              .map(TimedAnswer::answer)
                              .map(Answer::value)
                              .orElse("");
                      cells(question, value).forEach(row::add);
                    }));
    return row;
  }

  /** Returns the columns of a question: its id, and what is derived from its values. */
  static List<String> columns(String questionnaire, Question question) {
    List<String> columns = new ArrayList<>();
    columns.add(questionnaire + "." + question.id());
    question
        .kind()
        .parts()
        .forEach(part -> columns.add(questionnaire + "." + question.id() + "_" + part));
    return columns;
  }

  /** Returns the cells of a question's columns. */
  static List<String> cells(Question question, String value) {
    List<String> cells = new ArrayList<>();
    cells.add(SpreadsheetText.marked(value));
    question.kind().parts().forEach(part -> cells.add(question.kind().part(part, value)));
    return cells;
  }

  /** Returns whether there are trials. */
  boolean isEmpty() {
    return rows.isEmpty();
  }

  /** Returns the table with its header. */
  String text() {
    List<Object> header = new ArrayList<>(TrialColumns.FIRST);
    header.addAll(factors);
    header.addAll(stimuli);
    header.addAll(TrialColumns.RESULT);
    questions.forEach(
        (name, asked) -> asked.forEach(question -> header.addAll(columns(name, question))));
    CsvWriter table = CsvWriter.bare();
    table.row(header);
    rows.forEach(table::row);
    return table.toString();
  }
}
