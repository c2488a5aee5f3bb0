package org.selectiverenderer.study.questionnaire;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.selectiverenderer.study.random.SeededRandom;

/**
 * A page of a questionnaire, shown on the screen at a time.
 *
 * @param id unique in the questionnaire; for a recognition list the area
 * @param title may be empty
 * @param text text before the questions, paragraphs separated by line ends; may be empty
 * @param picture a PNG or JPEG file
 * @param audio a sound file that is played when the page is shown
 * @param questions the questions; empty for a page to be read
 * @param shuffled whether the questions have a random order for each participant
 * @param when the branching rule; empty for a page that is always shown
 */
public record QuestionnairePage(
    String id,
    String title,
    String text,
    Optional<Path> picture,
    Optional<Path> audio,
    List<Question> questions,
    boolean shuffled,
    Optional<BranchingRule> when) {
  public QuestionnairePage {
    questions = List.copyOf(questions);
  }

  /** Makes a page without audio. */
  public QuestionnairePage(
      String id,
      String title,
      String text,
      Optional<Path> picture,
      List<Question> questions,
      boolean shuffled,
      Optional<BranchingRule> when) {
    this(id, title, text, picture, Optional.empty(), questions, shuffled, when);
  }

  /**
   * Returns the page with the questions in a participant's order. The order is random by study,
   * questionnaire, participant and page, and is the same at every call and on every machine.
   *
   * @param seed of the study
   * @param name of the questionnaire in the study
   */
  QuestionnairePage ordered(long seed, String name, String participant) {
    long mixed = SeededRandom.mixed(seed, name + '/' + participant + '/' + id);
    List<List<Question>> order = new ArrayList<>(units());
    if (shuffled) {
      Collections.shuffle(order, new Random(mixed));
    }
    return new QuestionnairePage(
        id,
        title,
        text,
        picture,
        audio,
        order.stream()
            .flatMap(List::stream)
            .map(question -> question.ordered(new Random(SeededRandom.mixed(mixed, question.id()))))
            .toList(),
        false,
        when);
  }

  /** Returns the questions that stay together in a random order: the rows of a grid. */
  private List<List<Question>> units() {
    List<List<Question>> units = new ArrayList<>();
    String grid = "";
    for (Question question : questions) {
      String own = question.kind().grid();
      if (own.isEmpty() || !own.equals(grid)) {
        units.add(new ArrayList<>());
      }
      units.get(units.size() - 1).add(question);
      grid = own;
    }
    return units;
  }

  /**
   * Returns the page in parts that are laid out each by itself: a grid, or the questions between
   * grids.
   */
  public List<QuestionnairePage> parts() {
    List<List<Question>> parts = new ArrayList<>();
    String grid = "";
    for (Question question : questions) {
      String own = question.kind().grid();
      if (parts.isEmpty() || !own.equals(grid)) {
        parts.add(new ArrayList<>());
      }
      parts.get(parts.size() - 1).add(question);
      grid = own;
    }
    return parts.stream()
        .map(part -> new QuestionnairePage(id, title, text, picture, audio, part, false, when))
        .toList();
  }

  /** Returns the text above the page's questions if all are rows of one grid; may be empty. */
  public String stem() {
    return questions.isEmpty() ? "" : questions.get(0).kind().stem();
  }

  /** Returns the page with all occurrences of a text replaced by another. */
  QuestionnairePage naming(String old, String other) {
    return new QuestionnairePage(
        id,
        title.replace(old, other),
        text.replace(old, other),
        picture,
        audio,
        questions.stream().map(question -> question.naming(old, other)).toList(),
        shuffled,
        when);
  }

  /** Returns the questions that are asked after these answers, in order. */
  public List<Question> asked(Map<String, Answer> answers) {
    List<Question> asked = new ArrayList<>();
    Map<String, Answer> counting = new HashMap<>(answers);
    for (Question question : questions) {
      if (question.when().map(when -> when.holds(counting)).orElse(true)) {
        asked.add(question);
      } else {
        counting.remove(question.id()); // Answers to skipped questions do not count.
      }
    }
    return asked;
  }

  /**
   * Returns the headings over the fields: those of the questions if all have the same, else none.
   */
  public List<String> headings(ParticipantMessages wording) {
    List<List<String>> each =
        questions.stream().map(question -> question.kind().headings(wording)).distinct().toList();
    return each.size() == 1 ? each.get(0) : List.of();
  }
}
