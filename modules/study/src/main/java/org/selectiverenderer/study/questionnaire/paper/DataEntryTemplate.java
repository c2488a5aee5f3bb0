package org.selectiverenderer.study.questionnaire.paper;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.AnswerTableKind;
import org.selectiverenderer.study.questionnaire.AnswersCsvBuilder;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.Respondent;

/**
 * The data-entry template for a {@link PaperQuestionnaireHtml}: a CSV table to type the answers
 * into. For recognition lists alone, or expectancy ratings alone, it has the columns of those
 * tables; else a row for each question, with the valid answers.
 */
public final class DataEntryTemplate {
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

  private DataEntryTemplate() {}

  /**
   * Returns a template without answers.
   *
   * @param condition the participant's condition; empty if unknown
   */
  public static String text(
      List<Questionnaire> questionnaires,
      ParticipantMessages wording,
      String participant,
      String condition) {
    Set<AnswerTableKind> tables =
        questionnaires.stream()
            .flatMap(each -> each.questions().stream())
            .map(question -> question.kind().table())
            .collect(Collectors.toSet());
    Optional<AnswerTableKind> only =
        tables.stream()
            .filter(table -> table != AnswerTableKind.ANSWERS && tables.size() == 1)
            .findFirst();
    if (only.isPresent()) {
      AnswersCsvBuilder empty = new AnswersCsvBuilder();
      questionnaires.forEach(
          each -> empty.add(new Respondent(participant, "", condition, each.id()), each, Map.of()));
      return empty.text(only.get());
    }
    CsvWriter text = new CsvWriter().row(COLUMNS);
    for (Questionnaire questionnaire : questionnaires) {
      for (QuestionnairePage page : questionnaire.pages()) {
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
