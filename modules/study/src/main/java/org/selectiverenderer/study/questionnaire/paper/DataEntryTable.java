package org.selectiverenderer.study.questionnaire.paper;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;

/**
 * Answers on paper that were typed into a {@link DataEntryTemplate}: for recognition lists {@code
 * participant,condition,area,object,response,confidence}, for expectancy {@code
 * participant,area,object,rating}, for all kinds of questions {@code
 * participant,questionnaire,question,value} and optionally {@code condition} and {@code
 * confidence}. Other columns are ignored: the study knows the properties of an object. A row
 * without an answer is a question that was not answered.
 *
 * @param rows the rows with an answer, in the file's order
 */
public record DataEntryTable(List<Filled> rows) {
  private static final String LEFT_OUT = "; the answer is left out";

  /**
   * A row with an answer.
   *
   * @param condition as typed; empty if missing
   * @param step id of the questionnaire
   * @param question id of the question
   */
  public record Filled(
      String participant,
      String condition,
      String step,
      String question,
      Answer answer,
      SourceLocation location) {}

  private record Asked(String participant, String step, String question) {}

  public DataEntryTable {
    rows = List.copyOf(rows);
  }

  /**
   * Reads a table.
   *
   * @param asked finds the questionnaire by the ids of a participant and a step; empty for none
   * @return empty if the file is not such a table, which is then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<DataEntryTable> read(
      Path file,
      BiFunction<String, String, Optional<Questionnaire>> asked,
      ParticipantMessages wording,
      ProblemCollector problems)
      throws IOException {
    Optional<CsvTable> table =
        CsvTable.read(
            file,
            CsvColumnSpec.of(List.of("participant")),
            (at, message) -> problems.error(at, message + "; it is not collected"));
    if (table.isEmpty()) {
      return Optional.empty();
    }
    DataEntryColumns form = DataEntryColumns.of(table.get());
    if (!table.get().require(form.columns(), String.join(",", form.columns()))) {
      return Optional.empty();
    }
    List<Filled> rows = new ArrayList<>();
    for (CsvRow row : table.get().rows()) {
      new RowReader(row, form, wording, problems).read(asked).ifPresent(rows::add);
    }
    return Optional.of(new DataEntryTable(withoutDoubles(rows, problems)));
  }

  /** Reads one row, or reports why it cannot be used. */
  private record RowReader(
      CsvRow row, DataEntryColumns form, ParticipantMessages wording, ProblemCollector problems) {
    Optional<Filled> read(BiFunction<String, String, Optional<Questionnaire>> asked) {
      String value = row.cell(form.value());
      String confidence = form.confidence(row);
      if (value.isEmpty() && confidence.isEmpty()) {
        return Optional.empty();
      }
      Optional<Question> question =
          asked
              .apply(row.cell("participant"), form.step(row))
              .flatMap(questionnaire -> questionnaire.question(row.cell(form.question())));
      Optional<Answer> answer =
          question.isPresent()
              ? answer(question.get(), value, confidence)
              : Optional.of(Answer.of(value)); // Reported later: the study has no such question.
      return answer
          .filter(one -> named())
          .map(
              one ->
                  new Filled(
                      row.cell("participant"),
                      form.condition(row),
                      form.step(row),
                      row.cell(form.question()),
                      one,
                      row.location()));
    }

    private Optional<Answer> answer(Question question, String value, String confidence) {
      List<AnswerField> fields = question.kind().fields(wording);
      if (value.isEmpty()) {
        return fault(form.value(), "there is a confidence but no answer");
      }
      Optional<String> known = fields.get(0).typed(value);
      if (known.isEmpty()) {
        return fault(form.value(), form.notAllowed(value, fields.get(0)));
      }
      if (confidence.isEmpty()) {
        return Optional.of(Answer.of(known.get()));
      }
      if (fields.size() < 2) {
        return fault("confidence", "the question asks for no confidence");
      }
      Optional<String> level = fields.get(1).typed(confidence);
      if (level.isEmpty()) {
        return fault(
            "confidence",
            "'%s' is not a confidence from %s".formatted(confidence, fields.get(1).allowed()));
      }
      return Optional.of(new Answer(known.get(), Integer.parseInt(level.get())));
    }

    private Optional<Answer> fault(String column, String message) {
      problems.error(row.location(column), message + LEFT_OUT);
      return Optional.empty();
    }

    private boolean named() {
      for (String column : form.names()) {
        if (row.cell(column).isEmpty()) {
          problems.error(row.location(column), "the " + column + " is missing" + LEFT_OUT);
          return false;
        }
      }
      return true;
    }
  }

  /** Removes duplicates: of equal answers to a question one is kept, of different ones none. */
  private static List<Filled> withoutDoubles(List<Filled> rows, ProblemCollector problems) {
    Map<Asked, Filled> first = new HashMap<>();
    Set<Asked> torn = new HashSet<>();
    List<Filled> once = new ArrayList<>();
    for (Filled row : rows) {
      Asked question = new Asked(row.participant(), row.step(), row.question());
      Filled earlier = first.putIfAbsent(question, row);
      if (earlier == null) {
        once.add(row);
        continue;
      }
      boolean alike = earlier.answer().equals(row.answer());
      problems.error(
          row.location(),
          "a second answer of participant %s to %s; line %d has the first%s"
              .formatted(
                  row.participant(),
                  row.question(),
                  earlier.location().line(),
                  alike ? "; it is left out" : "; they differ, so both are left out"));
      if (!alike) {
        torn.add(question);
      }
    }
    once.removeIf(row -> torn.contains(new Asked(row.participant(), row.step(), row.question())));
    return once;
  }
}
