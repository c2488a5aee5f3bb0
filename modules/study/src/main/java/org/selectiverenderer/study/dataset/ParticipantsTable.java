package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvErrorHandler;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;

/**
 * The contents of a study's {@code participants.tsv}. The program documents its own columns; any
 * other column holds the answers to a question of the form.
 *
 * @param columns names of the columns, that of the participant's id first
 * @param rows cells by column name; a missing value is empty
 */
public record ParticipantsTable(List<String> columns, List<Map<String, String>> rows) {
  /** Column of the ids of a recruiting service, which no dataset has. */
  public static final String RECRUITMENT = "recruitment_ids";

  private static final String ID = "participant_id";

  private static final Map<String, TableColumn> KNOWN = known();

  public ParticipantsTable {
    columns = List.copyOf(columns);
    rows = List.copyOf(rows);
  }

  /**
   * Reads the file.
   *
   * @return a table without rows if the file does not exist
   */
  static ParticipantsTable read(Path file, ProblemCollector problems) throws IOException {
    ParticipantsTable none = new ParticipantsTable(List.of(ID), List.of());
    if (!Files.isRegularFile(file)) {
      return none;
    }
    CsvErrorHandler faults =
        new CsvErrorHandler() {
          @Override
          public void fault(SourceLocation at, String message) {
            problems.warning(at, message + "; the line is left out");
          }
        };
    Optional<CsvTable> table = CsvTable.read(file, CsvColumnSpec.of(List.of(ID)), faults);
    if (table.isEmpty() || !table.get().has(ID)) {
      return none;
    }
    List<String> columns = table.get().header();
    List<Map<String, String>> rows = new ArrayList<>();
    table
        .get()
        .rows()
        .forEach(
            row -> {
              Map<String, String> cells = new LinkedHashMap<>();
              for (String column : columns) {
                String cell = row.cell(column);
                cells.put(column, cell.equals("n/a") ? "" : cell);
              }
              rows.add(cells);
            });
    return new ParticipantsTable(columns, rows);
  }

  /** Returns the table without some participants. */
  ParticipantsTable without(Set<String> participants) {
    return new ParticipantsTable(
        columns,
        rows.stream()
            .filter(
                row -> !participants.contains(row.getOrDefault(ID, "").replaceFirst("sub-", "")))
            .toList());
  }

  /** Returns whether the program itself writes a column, or it answers a question of the form. */
  public static boolean documented(String name, Questionnaire form) {
    return name.equals("age")
        || KNOWN.containsKey(name)
        || form.questions().stream().anyMatch(question -> question.id().equals(name));
  }

  /**
   * Returns the documentation of a column.
   *
   * @param form the study's form, whose questions the columns answer
   */
  public static TableColumn column(String name, Questionnaire form) {
    if (name.equals("age")) {
      return age(form);
    }
    TableColumn known = KNOWN.get(name);
    return known != null
        ? known
        : TableColumn.text(name, "the answer to the form's question " + name.replace('_', ' '));
  }

  /** Returns the documentation of the age, which each study asks in its own way. */
  private static TableColumn age(Questionnaire form) {
    Optional<Question> asked =
        form.questions().stream()
            .filter(question -> question.sets().equals(Optional.of(Question.Sets.AGE)))
            .findFirst();
    if (asked.isEmpty()) {
      return TableColumn.text("age", "the participant's age; the form does not ask it");
    }
    String question = asked.get().text().isEmpty() ? asked.get().id() : asked.get().text();
    return asked.get().kind().numbers().isPresent()
        ? TableColumn.number(
            "age",
            "year",
            "age, a number as the participant wrote it, the answer to the form's question: "
                + question)
        : TableColumn.text(
            "age", "age, as the participant answered the form's question: " + question);
  }

  private static Map<String, TableColumn> known() {
    Map<String, String> assigned = new LinkedHashMap<>();
    assigned.put("schedule", "it was the participant's turn");
    assigned.put("experimenter", "chosen by the experimenter");
    Map<String, String> simulated = new LinkedHashMap<>();
    simulated.put("true", "the program, for tests");
    simulated.put("false", "a person");
    Map<String, TableColumn> known = new LinkedHashMap<>();
    for (TableColumn column :
        List.of(
            TableColumn.text(ID, "the participant, sub- and the id"),
            ConditionColumnFactory.column("how objects were rendered for the participant"),
            TableColumn.whole("place", "the participant's place in the schedule, from 1"),
            TableColumn.category("assigned_by", assigned, "who assigned the condition"),
            ConditionColumnFactory.column(
                "instead_of", "the condition of the schedule that was replaced"),
            TableColumn.category("simulated", simulated, "who took part"))) {
      known.put(column.name(), column);
    }
    return known;
  }

  /**
   * Returns the table.
   *
   * @param form the study's form
   * @param recruited ids of a recruiting service by participants; without any there is no column
   */
  DataTable table(Questionnaire form, Map<String, String> recruited) {
    List<TableColumn> all = new ArrayList<>();
    columns.forEach(name -> all.add(column(name, form)));
    if (!recruited.isEmpty()) {
      all.add(
          TableColumn.text(
              RECRUITMENT,
              "ids that a recruiting service gave the participant, joined by |; they lead to a"
                  + " person and are not passed on"));
    }
    DataTable table =
        new DataTable("participants", "a participant who was assigned a condition", all);
    for (Map<String, String> row : rows) {
      List<@Nullable String> cells = new ArrayList<>();
      columns.forEach(name -> cells.add(row.get(name)));
      if (!recruited.isEmpty()) {
        cells.add(recruited.get(row.getOrDefault(ID, "").replaceFirst("^sub-", "")));
      }
      table.add(cells);
    }
    return table;
  }
}
