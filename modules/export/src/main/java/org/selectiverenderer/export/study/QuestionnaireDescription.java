package org.selectiverenderer.export.study;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.BranchingRule;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.RankingField;
import org.selectiverenderer.study.questionnaire.SliderField;

/** Describes questionnaires for the page, as web/src/study/description.ts reads them. */
final class QuestionnaireDescription {
  private final ParticipantMessages wording;
  private final StudyPictures pictures;

  QuestionnaireDescription(ParticipantMessages wording, StudyPictures pictures) {
    this.wording = wording;
    this.pictures = pictures;
  }

  /** Puts the pages of a questionnaire into a list. */
  void describe(Questionnaire questionnaire, ArrayNode pages) {
    questionnaire.pages().forEach(page -> describe(page, pages.addObject()));
  }

  private void describe(QuestionnairePage page, ObjectNode json) {
    json.put("id", page.id());
    text(json, "title", page.title());
    text(json, "text", page.text());
    page.picture().ifPresent(file -> json.put("picture", pictures.address(file)));
    page.when().ifPresent(rule -> describe(rule, json.putObject("when")));
    List<String> headings = page.headings(wording);
    if (!headings.isEmpty()) {
      headings.forEach(json.putArray("headings")::add);
    }
    ArrayNode questions = json.putArray("questions");
    page.questions().forEach(question -> describe(question, questions.addObject()));
  }

  private void describe(Question question, ObjectNode json) {
    json.put("id", question.id());
    json.put("kind", question.kind().spelling());
    text(json, "text", question.text());
    text(json, "grid", question.kind().grid());
    text(json, "stem", question.kind().stem());
    truth(json, "optional", question.optional());
    truth(json, "personal", question.personal());
    truth(json, "example", question.kind().example());
    question.must().ifPresent(value -> json.put("must", value));
    question.sets().ifPresent(setting -> json.put("sets", setting.spelling()));
    question.when().ifPresent(rule -> describe(rule, json.putObject("when")));
    ArrayNode fields = json.putArray("fields");
    question.kind().fields(wording).forEach(field -> describe(field, fields.addObject()));
  }

  private static void describe(BranchingRule rule, ObjectNode json) {
    json.put("question", rule.question());
    rule.is().stream().sorted().forEach(json.putArray("is")::add);
  }

  private void describe(AnswerField field, ObjectNode json) {
    if (field instanceof AnswerField.Choice choice) {
      json.put("type", "choice");
      truth(json, "several", choice.several());
      text(json, "least", choice.least());
      text(json, "most", choice.most());
      options(choice.options(), json.putArray("options"));
    } else if (field instanceof AnswerField.Line line) {
      json.put("type", "line");
      json.put("lines", line.lines());
      text(json, "unit", line.unit());
      line.range().ifPresent(range -> describe(range, json.putObject("range")));
    } else if (field instanceof SliderField slider) {
      json.put("type", "slider");
      text(json, "least", slider.least());
      text(json, "most", slider.most());
      truth(json, "number", slider.number());
      truth(json, "marks", slider.marks());
      slider.start().ifPresent(position -> json.put("start", position));
      slider.values().forEach(json.putArray("values")::add);
    } else if (field instanceof RankingField ranking) {
      json.put("type", "ranking");
      options(ranking.options(), json.putArray("options"));
    }
  }

  private static void describe(AnswerField.Line.Range range, ObjectNode json) {
    json.put("least", range.least());
    json.put("most", range.most());
    json.put("whole", range.whole());
  }

  private void options(List<ChoiceOption> options, ArrayNode json) {
    for (ChoiceOption option : options) {
      ObjectNode one = json.addObject();
      one.put("value", option.value());
      one.put("label", option.label());
      text(one, "note", option.note());
      option.picture().ifPresent(file -> one.put("picture", pictures.address(file)));
    }
  }

  private static void text(ObjectNode json, String key, String text) {
    Optional.of(text).filter(some -> !some.isEmpty()).ifPresent(some -> json.put(key, some));
  }

  private static void truth(ObjectNode json, String key, boolean truth) {
    if (truth) {
      json.put(key, true);
    }
  }
}
