package org.selectiverenderer.experiment.questionnaire;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What is asked in one step of a session, in one language.
 *
 * @param id of the step: letters, digits, hyphens
 * @param name of the questionnaire in the study, from which its order of questions is drawn; of
 *     memory lists that of all areas
 * @param area that it is about; empty for none in particular
 * @param pages at least one
 * @param scores computed from the answers; may be none
 */
public record Questionnaire(
    String id, String name, String area, List<Page> pages, List<ScaleScore> scores) {
  public Questionnaire {
    pages = List.copyOf(pages);
    scores = List.copyOf(scores);
  }

  /** The same under another name, about an area or none in particular. */
  public Questionnaire as(String other, String place) {
    return new Questionnaire(
        place.isEmpty() ? other : other + "-" + place, other, place, pages, scores);
  }

  /**
   * The same about an area, whose name stands where the texts have {@code {area}}.
   *
   * @param called how the language calls it
   */
  public Questionnaire about(String place, String called) {
    return new Questionnaire(
        name + "-" + place,
        name,
        place,
        pages.stream().map(page -> page.naming("{area}", called)).toList(),
        scores);
  }

  /** As a participant meets it. */
  public Questionnaire ordered(long seed, String participant) {
    return new Questionnaire(
        id,
        name,
        area,
        pages.stream().map(page -> page.ordered(seed, name, participant)).toList(),
        scores);
  }

  /** All questions there may be, in order. */
  public List<Question> questions() {
    return pages.stream().flatMap(page -> page.questions().stream()).toList();
  }

  /** The question of an id. */
  public Optional<Question> question(String wanted) {
    return questions().stream().filter(question -> question.id().equals(wanted)).findFirst();
  }

  /** The pages that are shown after these answers, in order. */
  public List<Page> shown(Map<String, Answer> answers) {
    List<Page> shown = new ArrayList<>();
    Map<String, Answer> counting = new HashMap<>(answers);
    for (Page page : pages) {
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

  /** The answers that count: those to questions that are asked after the others. */
  public Map<String, Answer> counting(Map<String, Answer> answers) {
    Map<String, Answer> counting = new HashMap<>();
    for (Page page : shown(answers)) {
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
   * What tables may have of these answers, in order: a row for each question that was asked, but
   * for examples and what is personal.
   */
  public List<TabledAnswer> tabled(Map<String, GivenAnswer> given) {
    Map<String, Answer> answers = new HashMap<>();
    given.forEach((question, one) -> answers.put(question, one.answer()));
    Map<String, Answer> counting = counting(answers);
    List<TabledAnswer> tabled = new ArrayList<>();
    for (Page page : shown(counting)) {
      for (Question question : page.asked(counting)) {
        GivenAnswer own = given.getOrDefault(question.id(), GivenAnswer.NONE);
        if (!question.personal() && !own.personal() && !question.kind().example()) {
          tabled.add(new TabledAnswer(page, question, own));
        }
      }
    }
    return tabled;
  }

  /** The answer that decides something of the session. */
  public Optional<String> set(Question.Sets what, Map<String, Answer> answers) {
    Map<String, Answer> counting = counting(answers);
    return questions().stream()
        .filter(question -> question.sets().equals(Optional.of(what)))
        .map(question -> counting.getOrDefault(question.id(), Answer.NONE).value())
        .filter(value -> !value.isEmpty())
        .findFirst();
  }

  /** Whether the answers forbid to take part. */
  public boolean refused(Map<String, Answer> answers) {
    Map<String, Answer> counting = counting(answers);
    return questions().stream()
        .anyMatch(question -> question.refuses(counting.getOrDefault(question.id(), Answer.NONE)));
  }
}
