package org.selectiverenderer.study.dataset;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.questionnaire.AnswerRow;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.StimulusItem;
import org.selectiverenderer.study.questionnaire.TimedAnswer;
import org.selectiverenderer.study.session.LoadedStudy;

/**
 * The table of a session's answers by screen, from its journal: the last answer to each question.
 * Answers that the study marks as personal are left out.
 */
public final class SessionAnswersTable {
  private static final Map<String, String> YES = yes();

  private SessionAnswersTable() {}

  /** Returns the columns of {@link #rows}. */
  public static List<TableColumn> columns() {
    return List.of(
        TableColumn.text(
            "question", "the question's id; for recognition and expectancy the object"),
        TableColumn.text(
            "response",
            "what was answered; several choices, and an order from first to last, are joined by |;"
                + " a row question_option has the option's rank"),
        TableColumn.whole(
            "confidence", "how sure the participant was, 1 (not at all) to 5 (certain)"),
        TableColumn.number(
            "response_time", "s", "from when the question was shown until the value that counts"),
        TableColumn.whole("place", "the question's number on its screen, from 1"),
        TableColumn.text("area", "of the scene that the question is about"),
        TableColumn.text("consistency", "of the object with the area's schema"),
        TableColumn.category("present", YES, "whether the object was in the scene"));
  }

  private static Map<String, String> yes() {
    Map<String, String> levels = new LinkedHashMap<>();
    levels.put("yes", "it was there");
    levels.put("no", "it was not");
    return levels;
  }

  /**
   * Returns the rows of each screen that was begun, by the id of its step, in order.
   *
   * @param material the questionnaires: which answers are personal, and which objects were present
   * @param problems receives each screen that the study no longer has, which is left out
   */
  public static Map<String, List<List<@Nullable Object>>> rows(
      LoadedStudy material, RecordedSession session, ProblemCollector problems) {
    Map<String, List<List<@Nullable Object>>> rows = new LinkedHashMap<>();
    session
        .given()
        .forEach(
            (step, given) ->
                material
                    .questionnaire(step, session.folder().participant())
                    .ifPresentOrElse(
                        asked -> {
                          List<List<@Nullable Object>> own = rows(asked, given);
                          if (!own.isEmpty()) {
                            rows.put(step, own);
                          }
                        },
                        () ->
                            problems.warning(
                                SourceLocation.of(session.folder().journal().toString()),
                                ("the study no longer has %s; the answers to it are left out,"
                                        + " as it is unknown which of them are personal")
                                    .formatted(step))));
    return rows;
  }

  private static List<List<@Nullable Object>> rows(
      Questionnaire asked, Map<String, TimedAnswer> given) {
    List<List<@Nullable Object>> rows = new ArrayList<>();
    for (AnswerRow one : asked.tabled(given)) {
      if (!one.given().answer().value().isEmpty()) {
        rows.add(row(asked, one.question(), one.given()));
        for (String part : one.question().kind().parts()) {
          List<@Nullable Object> further = row(asked, one.question(), one.given());
          further.set(0, one.question().id() + "_" + part);
          further.set(1, one.question().kind().part(part, one.given().answer().value()));
          rows.add(further);
        }
      }
    }
    return rows;
  }

  private static List<@Nullable Object> row(
      Questionnaire asked, Question question, TimedAnswer given) {
    Optional<StimulusItem> item = question.kind().about();
    Optional<StimulusItem> remembered = item.filter(one -> !one.type().isEmpty());
    List<@Nullable Object> row = new ArrayList<>();
    row.add(question.id());
    row.add(given.answer().value());
    row.add(given.answer().confidence() > 0 ? given.answer().confidence() : null);
    row.add(given.last().isPresent() ? given.last().getAsLong() / 1000.0 : null);
    row.add(given.place() > 0 ? given.place() : null);
    row.add(item.map(StimulusItem::area).orElse(asked.area()));
    row.add(remembered.map(StimulusItem::type).orElse(null));
    row.add(remembered.map(one -> one.present() ? "yes" : "no").orElse(null));
    return row;
  }
}
