package org.selectiverenderer.experiment.questionnaire;

import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Where a participant is in a questionnaire: on which page, what is answered so far and what is
 * still open, and since when each question is in view. Whatever shows it, a window or a panel in a
 * headset, asks and tells this; so answers come about alike. Belongs to one thread.
 */
public final class QuestionnaireCourse {
  /** Hears what happens, on the thread that shows the questionnaire. */
  public interface Listener {
    /** A page is on the screen. */
    void shown(Page page, List<Question> asked);

    /**
     * An answer, or a change of one.
     *
     * @param milliseconds since the question came into view
     * @param place of it on its page, from 1
     */
    void answered(Question question, Answer answer, long milliseconds, int place);
  }

  private final Questionnaire questionnaire;
  private final Wording wording;
  private final Listener listener;
  private final Map<String, Answer> answers;
  private final Map<String, Long> seen = new HashMap<>();
  private Page page;

  /**
   * @param known answers given before, by the questions' ids
   * @param from id of the page to begin with; the first if there is none such
   */
  public QuestionnaireCourse(
      Questionnaire questionnaire,
      Wording wording,
      Map<String, Answer> known,
      Optional<String> from,
      Listener listener) {
    this.questionnaire = questionnaire;
    this.wording = wording;
    this.listener = listener;
    answers = new HashMap<>(known);
    List<Page> shown = pages();
    page =
        shown.stream()
            .filter(each -> from.equals(Optional.of(each.id())))
            .findFirst()
            .orElse(shown.get(0));
  }

  /** The pages that are shown after the answers so far. */
  public List<Page> pages() {
    return questionnaire.shown(answers);
  }

  /** The page that is shown. */
  public Page page() {
    return page;
  }

  /** Its number among the pages, from 0. */
  public int number() {
    return pages().indexOf(page);
  }

  /** The answers so far, by the questions' ids. */
  public Map<String, Answer> answers() {
    return Collections.unmodifiableMap(answers);
  }

  /** The answer to a question so far. */
  public Answer answer(Question question) {
    return answers.getOrDefault(question.id(), Answer.NONE);
  }

  /** The questions of the page that are asked after the answers so far, in order. */
  public List<Question> asked() {
    return page.asked(answers);
  }

  /** The page is on the screen. */
  public void begin() {
    listener.shown(page, asked());
  }

  /** A question of the page is in view; only the first time counts. */
  public void saw(Question question) {
    seen.putIfAbsent(question.id(), System.nanoTime());
  }

  /**
   * A question of the page is answered.
   *
   * @param settled whether that is to be kept: not while somebody is typing
   * @param at when, by the computer's monotonic clock
   */
  public void answer(Question question, Answer answer, boolean settled, long at) {
    int place = asked().indexOf(question) + 1;
    answers.put(question.id(), answer);
    long since = seen.computeIfAbsent(question.id(), first -> at);
    if (settled) {
      listener.answered(question, answer, Math.max(0, (at - since) / 1_000_000), place);
    }
  }

  /** How many questions of the page are asked and still needed. */
  public int open() {
    return (int)
        asked().stream().filter(question -> !question.complete(answer(question), wording)).count();
  }

  /** Whether an answer of the page forbids to take part. */
  public boolean refuses() {
    return asked().stream().anyMatch(question -> question.refuses(answer(question)));
  }

  /** Whether one may go on from the page. */
  public boolean mayGoOn() {
    return open() == 0 && !refuses();
  }

  /**
   * Turns the page.
   *
   * @param by 1 for the next one, -1 for the one before
   * @return whether there is one; else the page stays
   */
  public boolean turn(int by) {
    List<Page> shown = pages();
    int to = shown.indexOf(page) + by;
    if (to < 0 || to >= shown.size()) {
      return false;
    }
    page = shown.get(to);
    seen.clear();
    return true;
  }
}
