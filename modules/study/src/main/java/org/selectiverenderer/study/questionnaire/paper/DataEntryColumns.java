package org.selectiverenderer.study.questionnaire.paper;

import java.util.List;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ItemQuestionnaireKind;

/** The column layouts of a data-entry table. */
enum DataEntryColumns {
  /** A table of questions of all kinds. */
  ANY(
      "questionnaire",
      "question",
      "value",
      List.of("participant", "questionnaire", "question", "value")),
  RATINGS("area", "object", "rating", List.of("participant", "area", "object", "rating")),
  MEMORY(
      "area",
      "object",
      "response",
      List.of("participant", "condition", "area", "object", "response", "confidence"));

  private final String part;
  private final String question;
  private final String value;
  private final List<String> columns;

  DataEntryColumns(String part, String question, String value, List<String> columns) {
    this.part = part;
    this.question = question;
    this.value = value;
    this.columns = columns;
  }

  /** Returns the layout of a table, by its header. */
  static DataEntryColumns of(CsvTable table) {
    if (table.has("question") || table.has("value")) {
      return ANY;
    }
    return table.has("rating") ? RATINGS : MEMORY;
  }

  /** Returns the columns that the header must name. */
  List<String> columns() {
    return columns;
  }

  /** Returns the columns that must not be empty in a row with an answer. */
  List<String> names() {
    return List.of("participant", part, question);
  }

  String question() {
    return question;
  }

  String value() {
    return value;
  }

  /** Returns the id of a row's questionnaire. */
  String step(CsvRow row) {
    return switch (this) {
      case ANY -> row.cell(part);
      case RATINGS -> ItemQuestionnaireKind.EXPECTANCY.spelling() + "-" + row.cell(part);
      case MEMORY -> ItemQuestionnaireKind.RECOGNITION.spelling() + "-" + row.cell(part);
    };
  }

  String condition(CsvRow row) {
    return this == RATINGS ? "" : row.cellIfAny("condition");
  }

  String confidence(CsvRow row) {
    return this == RATINGS ? "" : row.cellIfAny("confidence");
  }

  String notAllowed(String typed, AnswerField field) {
    return switch (this) {
      case RATINGS -> "'%s' is not a rating from %s".formatted(typed, field.allowed());
      case MEMORY -> "'%s' is not %s".formatted(typed, field.allowed());
      case ANY -> "'%s' is not an answer; it must be %s".formatted(typed, field.allowed());
    };
  }
}
