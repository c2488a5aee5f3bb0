package org.selectiverenderer.experiment.questionnaire;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;

/**
 * What is on the screen at a time.
 *
 * @param id once in its questionnaire: of a memory list the area
 * @param title may be empty
 * @param text to be read before the questions, paragraphs divided by line ends; may be empty
 * @param picture a PNG or JPEG
 * @param questions none on a page that is only read
 * @param shuffled whether each participant has the questions in an order of his own
 * @param when what it depends on
 */
public record Page(
    String id,
    String title,
    String text,
    Optional<Path> picture,
    List<Question> questions,
    boolean shuffled,
    Optional<AskedIf> when) {
  public Page {
    questions = List.copyOf(questions);
  }

  /**
   * As a participant meets it. The order is drawn anew for each participant and page, and is the
   * same whenever it is asked for, on every machine.
   *
   * @param seed of the study
   * @param name of the questionnaire in the study
   */
  Page ordered(long seed, String name, String participant) {
    if (!shuffled) {
      return this;
    }
    List<Question> order = new ArrayList<>(questions);
    long mixed = seed;
    for (char c : (name + '/' + participant + '/' + id).toCharArray()) {
      mixed = (mixed ^ c) * 0x100000001B3L; // FNV-1a, whose low bits Random then spreads.
    }
    Collections.shuffle(order, new Random(mixed));
    return new Page(id, title, text, picture, order, false, when);
  }

  /** With a text in the place of another, in all that is read. */
  Page naming(String old, String other) {
    return new Page(
        id,
        title.replace(old, other),
        text.replace(old, other),
        picture,
        questions.stream().map(question -> question.naming(old, other)).toList(),
        shuffled,
        when);
  }

  /** The questions that are asked after these answers, in order. */
  public List<Question> asked(Map<String, Answer> answers) {
    List<Question> asked = new ArrayList<>();
    Map<String, Answer> counting = new HashMap<>(answers);
    for (Question question : questions) {
      if (question.when().map(when -> when.holds(counting)).orElse(true)) {
        asked.add(question);
      } else {
        counting.remove(question.id()); // An answer to what is no longer asked decides nothing.
      }
    }
    return asked;
  }

  /** The headings over the fields: those of its questions where all have the same. */
  public List<String> headings(Wording wording) {
    List<List<String>> each =
        questions.stream().map(question -> question.kind().headings(wording)).distinct().toList();
    return each.size() == 1 ? each.get(0) : List.of();
  }
}
