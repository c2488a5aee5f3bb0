package org.selectiverenderer.export.study;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.RankingField;

/** Describes where a participant's order of questions and options is not that of the files. */
final class ParticipantOrder {
  private final ParticipantMessages wording;

  ParticipantOrder(ParticipantMessages wording) {
    this.wording = wording;
  }

  /** Returns the orders that differ, as an object that is empty where none does. */
  ObjectNode of(Questionnaire written, Questionnaire ordered, ObjectNode json) {
    for (int i = 0; i < written.pages().size(); i++) {
      QuestionnairePage page = ordered.pages().get(i);
      List<String> before = ids(written.pages().get(i));
      List<String> after = ids(page);
      if (!before.equals(after)) {
        after.forEach(json.withObject("/questions").putArray(page.id())::add);
      }
      for (Question question : page.questions()) {
        List<String> shown = options(question);
        if (!shown.equals(options(written.question(question.id()).orElseThrow()))) {
          shown.forEach(json.withObject("/options").putArray(question.id())::add);
        }
      }
    }
    return json;
  }

  private static List<String> ids(QuestionnairePage page) {
    return page.questions().stream().map(Question::id).toList();
  }

  private List<String> options(Question question) {
    AnswerField field = question.kind().fields(wording).get(0);
    List<ChoiceOption> options =
        field instanceof AnswerField.Choice choice
            ? choice.options()
            : field instanceof RankingField ranking ? ranking.options() : List.of();
    return options.stream().map(ChoiceOption::value).toList();
  }
}
