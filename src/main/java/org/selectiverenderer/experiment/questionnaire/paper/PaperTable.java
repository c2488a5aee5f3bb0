package org.selectiverenderer.experiment.questionnaire.paper;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.experiment.questionnaire.AnswerField;
import org.selectiverenderer.experiment.questionnaire.AnswerTable;
import org.selectiverenderer.experiment.questionnaire.AnswersCsv;
import org.selectiverenderer.experiment.questionnaire.AskedBy;
import org.selectiverenderer.experiment.questionnaire.Page;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Questionnaire;
import org.selectiverenderer.experiment.questionnaire.Wording;

/**
 * The data-entry template for a {@link PaperPage}: a CSV table to type the answers into. For
 * recognition lists alone, or expectancy ratings alone, it has the columns of those tables; else a
 * row for each question, with the valid answers.
 */
public final class PaperTable {
  /** Columns of a template for questions of all kinds. */
  private static final List<String> COLUMNS =
      List.of(
          "participant",
          "condition",
          "questionnaire",
          "page",
          "question",
          "kind",
          "value",
          "confidence",
          "allowed");

  private PaperTable() {}

  /**
   * Returns a template without answers.
   *
   * @param condition the participant's condition; empty if unknown
   */
  public static String text(
      List<Questionnaire> questionnaires, Wording wording, String participant, String condition) {
    Set<AnswerTable> tables =
        questionnaires.stream()
            .flatMap(each -> each.questions().stream())
            .map(question -> question.kind().table())
            .collect(Collectors.toSet());
    Optional<AnswerTable> only =
        tables.stream()
            .filter(table -> table != AnswerTable.ANSWERS && tables.size() == 1)
            .findFirst();
    if (only.isPresent()) {
      AnswersCsv empty = new AnswersCsv();
      questionnaires.forEach(
          each -> empty.add(new AskedBy(participant, "", condition, each.id()), each, Map.of()));
      return empty.text(only.get());
    }
    CsvText text = new CsvText().row(COLUMNS);
    for (Questionnaire questionnaire : questionnaires) {
      for (Page page : questionnaire.pages()) {
        for (Question question : page.questions()) {
          List<AnswerField> fields = question.kind().fields(wording);
          text.row(
              participant,
              condition,
              questionnaire.id(),
              page.id(),
              question.id(),
              question.kind().spelling(),
              "",
              "",
              fields.get(0).allowed()
                  + (fields.size() > 1 ? " and confidence " + fields.get(1).allowed() : ""));
        }
      }
    }
    return text.toString();
  }
}
