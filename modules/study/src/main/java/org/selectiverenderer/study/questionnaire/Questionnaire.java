package org.selectiverenderer.study.questionnaire;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A questionnaire as asked in one step of a session, in one language.
 *
 * @param id of the step: letters, digits, hyphens
 * @param name of the questionnaire in the study, which seeds the order of questions; recognition
 *     lists of all areas share one name
 * @param area the area that it is about; empty for none
 * @param pages at least one
 * @param scores definitions of the scores; may be empty
 */
public record Questionnaire(
    String id,
    String name,
    String area,
    List<QuestionnairePage> pages,
    List<ScoreDefinition> scores) {
  public Questionnaire {
    pages = List.copyOf(pages);
    scores = List.copyOf(scores);
  }

  /** Returns this questionnaire under another name, about an area or none. */
  public Questionnaire as(String other, String place) {
    return new Questionnaire(
        place.isEmpty() ? other : other + "-" + place, other, place, pages, scores);
  }

  /**
   * Returns this questionnaire about an area, whose name replaces {@code {area}} in the texts.
   *
   * @param called the area's name in the study's language
   */
  public Questionnaire about(String place, String called) {
    return new Questionnaire(
        name + "-" + place,
        name,
        place,
        pages.stream().map(page -> page.naming("{area}", called)).toList(),
        scores);
  }

  /** Returns this questionnaire with the questions in a participant's order. */
  public Questionnaire ordered(long seed, String participant) {
    return new Questionnaire(
        id,
        name,
        area,
        pages.stream().map(page -> page.ordered(seed, name, participant)).toList(),
        scores);
  }

  /** Returns the questions of all pages, in order. */
  public List<Question> questions() {
    return pages.stream().flatMap(page -> page.questions().stream()).toList();
  }

  /** Returns the question with an id. */
  public Optional<Question> question(String wanted) {
    return questions().stream().filter(question -> question.id().equals(wanted)).findFirst();
  }

  /** Returns the pages that are shown after these answers, in order. */
  public List<QuestionnairePage> shown(Map<String, Answer> answers) {
    List<QuestionnairePage> shown = new ArrayList<>();
    Map<String, Answer> counting = new HashMap<>(answers);
    for (QuestionnairePage page : pages) {
      boolean open = page.when().map(when -> when.holds(counting)).orElse(true);
      List<Question> asked = open ? page.asked(counting) : List.of();
      if (open) {
        shown.add(page);
      }
      page.questions().stream()
          .filter(question -> !asked.contains(question))
          .forEach(question -> counting.remove(question.id()));
    }
    return shown;
  }

  /** Returns the answers that count: those to questions that the branching rules do not skip. */
  public Map<String, Answer> counting(Map<String, Answer> answers) {
    Map<String, Answer> counting = new HashMap<>();
    for (QuestionnairePage page : shown(answers)) {
      for (Question question : page.asked(answers)) {
        boolean open = question.when().map(when -> when.holds(counting)).orElse(true);
        Answer answer = answers.getOrDefault(question.id(), Answer.NONE);
        if (open && !answer.equals(Answer.NONE)) {
          counting.put(question.id(), answer);
        }
      }
    }
    return counting;
  }

  /**
   * Returns the rows for tables, in order: one for each question that was asked, without examples
   * and personal questions. The places are those that the questions had at the end: an answer may
   * have opened a question before others that were answered already.
   */
  public List<AnswerRow> tabled(Map<String, TimedAnswer> given) {
    Map<String, Answer> answers = new HashMap<>();
    given.forEach((question, one) -> answers.put(question, one.answer()));
    Map<String, Answer> counting = counting(answers);
    List<AnswerRow> tabled = new ArrayList<>();
    for (QuestionnairePage page : shown(counting)) {
      List<Question> asked = page.asked(counting);
      for (Question question : asked) {
        TimedAnswer own =
            given.getOrDefault(question.id(), TimedAnswer.NONE).placed(asked.indexOf(question) + 1);
        if (!question.personal() && !own.personal() && !question.kind().example()) {
          tabled.add(new AnswerRow(page, question, own));
        }
      }
    }
    return tabled;
  }

  /** Returns the answer that determines a setting of the session. */
  public Optional<String> set(Question.Sets what, Map<String, Answer> answers) {
    Map<String, Answer> counting = counting(answers);
    return questions().stream()
        .filter(question -> question.sets().equals(Optional.of(what)))
        .map(question -> counting.getOrDefault(question.id(), Answer.NONE).value())
        .filter(value -> !value.isEmpty())
        .findFirst();
  }

  /** Returns whether the answers refuse consent. */
  public boolean refused(Map<String, Answer> answers) {
    Map<String, Answer> counting = counting(answers);
    return questions().stream()
        .anyMatch(question -> question.refuses(counting.getOrDefault(question.id(), Answer.NONE)));
  }
}
