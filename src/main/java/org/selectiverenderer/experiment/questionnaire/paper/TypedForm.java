package org.selectiverenderer.experiment.questionnaire.paper;

import java.util.List;
import org.selectiverenderer.base.csv.CsvRow;
import org.selectiverenderer.base.csv.CsvTable;
import org.selectiverenderer.experiment.questionnaire.AnswerField;
import org.selectiverenderer.experiment.questionnaire.ItemsKind;

/** Which columns of a typed table hold what. */
enum TypedForm {
  /** Of all kinds of questions. */
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

  TypedForm(String part, String question, String value, List<String> columns) {
    this.part = part;
    this.question = question;
    this.value = value;
    this.columns = columns;
  }

  /** The form that a header has. */
  static TypedForm of(CsvTable table) {
    if (table.has("question") || table.has("value")) {
      return ANY;
    }
    return table.has("rating") ? RATINGS : MEMORY;
  }

  /** Those that the header must name. */
  List<String> columns() {
    return columns;
  }

  /** Those that must not be empty where there is an answer. */
  List<String> names() {
    return List.of("participant", part, question);
  }

  String question() {
    return question;
  }

  String value() {
    return value;
  }

  /** The id of the questionnaire that a row is of. */
  String step(CsvRow row) {
    return switch (this) {
      case ANY -> row.cell(part);
      case RATINGS -> ItemsKind.EXPECTANCY.spelling() + "-" + row.cell(part);
      case MEMORY -> ItemsKind.RECOGNITION.spelling() + "-" + row.cell(part);
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
