package org.selectiverenderer.experiment.questionnaire;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.csv.CsvColumns;
import org.selectiverenderer.base.csv.CsvNumbers;
import org.selectiverenderer.base.csv.CsvRow;
import org.selectiverenderer.base.csv.CsvTable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.study.QuestionKind;

/**
 * Answers on paper, typed into the table that goes with a {@link PaperPage}: of memory {@code
 * participant,condition,area,object,response,confidence}, of expectancy {@code
 * participant,area,object,rating}. Other columns are not looked at: what an object is stands in the
 * study. A row without an answer is a question that was not answered.
 *
 * @param kind of all rows
 * @param rows with an answer, in the file's order
 */
public record PaperTable(QuestionKind kind, List<Filled> rows) {
  private static final String LEFT_OUT = "; the answer is left out";

  /**
   * A row that was filled in.
   *
   * @param condition as typed; empty where it was not, or is not asked for
   */
  public record Filled(
      String participant,
      String condition,
      String area,
      String object,
      Answer answer,
      Location location) {}

  private record Question(String participant, String area, String object) {}

  public PaperTable {
    rows = List.copyOf(rows);
  }

  /**
   * Reads a table.
   *
   * @return empty when it is none, which is then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<PaperTable> read(Path file, Problems problems) throws IOException {
    Optional<CsvTable> table =
        CsvTable.read(
            file,
            CsvColumns.of(List.of("participant", "area", "object")),
            (at, message) -> problems.error(at, message + "; it is not collected"));
    if (table.isEmpty()) {
      return Optional.empty();
    }
    QuestionKind kind =
        table.get().has("rating") ? QuestionKind.EXPECTANCY : QuestionKind.RECOGNITION;
    List<String> columns =
        kind == QuestionKind.EXPECTANCY
            ? List.of("participant", "area", "object", "rating")
            : List.of("participant", "condition", "area", "object", "response", "confidence");
    if (!table.get().require(columns, String.join(",", columns))) {
      return Optional.empty();
    }
    List<Filled> rows = new ArrayList<>();
    for (CsvRow row : table.get().rows()) {
      answer(row, kind, problems)
          .filter(answer -> named(row, problems))
          .ifPresent(
              answer ->
                  rows.add(
                      new Filled(
                          row.cell("participant"),
                          kind == QuestionKind.RECOGNITION ? row.cell("condition") : "",
                          row.cell("area"),
                          row.cell("object"),
                          answer,
                          row.location())));
    }
    return Optional.of(new PaperTable(kind, withoutDoubles(rows, problems)));
  }

  private static boolean named(CsvRow row, Problems problems) {
    for (String column : List.of("participant", "area", "object")) {
      if (row.cell(column).isEmpty()) {
        problems.error(row.location(column), "the " + column + " is missing" + LEFT_OUT);
        return false;
      }
    }
    return true;
  }

  private static Optional<Answer> answer(CsvRow row, QuestionKind kind, Problems problems) {
    if (kind == QuestionKind.EXPECTANCY) {
      String rating = row.cell("rating");
      if (rating.isEmpty() || rating.matches("[1-6]")) {
        return Optional.of(new Answer(rating, 0)).filter(answer -> !rating.isEmpty());
      }
      problems.error(
          row.location("rating"),
          CsvNumbers.quoted(rating) + " is not a rating from 1 to 6" + LEFT_OUT);
      return Optional.empty();
    }
    String value = row.cell("response").toLowerCase(Locale.ROOT);
    String confidence = row.cell("confidence");
    if (value.isEmpty() && confidence.isEmpty()) {
      return Optional.empty();
    }
    if (!value.equals("yes") && !value.equals("no")) {
      problems.error(
          row.location("response"),
          (value.isEmpty()
                  ? "there is a confidence but no answer"
                  : CsvNumbers.quoted(row.cell("response")) + " is not yes or no")
              + LEFT_OUT);
      return Optional.empty();
    }
    if (!confidence.isEmpty() && !confidence.matches("[1-5]")) {
      problems.error(
          row.location("confidence"),
          CsvNumbers.quoted(confidence) + " is not a confidence from 1 to 5" + LEFT_OUT);
      return Optional.empty();
    }
    return Optional.of(new Answer(value, confidence.isEmpty() ? 0 : confidence.charAt(0) - '0'));
  }

  /** Of answers given twice alike one is kept; of those that differ none. */
  private static List<Filled> withoutDoubles(List<Filled> rows, Problems problems) {
    Map<Question, Filled> first = new HashMap<>();
    Set<Question> torn = new HashSet<>();
    List<Filled> once = new ArrayList<>();
    for (Filled row : rows) {
      Question question = new Question(row.participant(), row.area(), row.object());
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
                  row.object(),
                  earlier.location().line(),
                  alike ? "; it is left out" : "; they differ, so both are left out"));
      if (!alike) {
        torn.add(question);
      }
    }
    once.removeIf(row -> torn.contains(new Question(row.participant(), row.area(), row.object())));
    return once;
  }
}
