package org.selectiverenderer.study.questionnaire;

import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A participant's progress in a questionnaire: the current page, the answers so far, the open
 * questions, and since when each question is in view. The window and the panel in a headset both
 * show and update this model, so that they behave alike. Belongs to one thread.
 */
public final class QuestionnaireProgress {
  /** Receives events, on the thread that shows the questionnaire. */
  public interface Listener {
    /** A page was shown. */
    void shown(QuestionnairePage page, List<Question> asked);

    /**
     * A question was answered, or an answer changed.
     *
     * @param milliseconds since the question came into view
     * @param place of the question on its page, from 1
     */
    void answered(Question question, Answer answer, long milliseconds, int place);
  }

  private final Questionnaire questionnaire;
  private final ParticipantMessages wording;
  private final Listener listener;
  private final Map<String, Answer> answers;
  private final Map<String, Long> seen = new HashMap<>();
  private QuestionnairePage page;

  /**
   * @param known answers given before, by the questions' ids
   * @param from id of the page to begin with; the first page if there is none with this id
   */
  public QuestionnaireProgress(
      Questionnaire questionnaire,
      ParticipantMessages wording,
      Map<String, Answer> known,
      Optional<String> from,
      Listener listener) {
    this.questionnaire = questionnaire;
    this.wording = wording;
    this.listener = listener;
    answers = new HashMap<>(known);
    List<QuestionnairePage> shown = pages();
    page =
        shown.stream()
            .filter(each -> from.equals(Optional.of(each.id())))
            .findFirst()
            .orElse(shown.get(0));
  }

  /** Returns the pages that are shown after the answers so far. */
  public List<QuestionnairePage> pages() {
    return questionnaire.shown(answers);
  }

  /** Returns the current page. */
  public QuestionnairePage page() {
    return page;
  }

  /** Returns the number of the current page, from 0. */
  public int number() {
    return pages().indexOf(page);
  }

  /** Returns the answers so far, by the questions' ids. */
  public Map<String, Answer> answers() {
    return Collections.unmodifiableMap(answers);
  }

  /** Returns the answer to a question so far. */
  public Answer answer(Question question) {
    return answers.getOrDefault(question.id(), Answer.NONE);
  }

  /**
   * Returns the questions of the current page that are asked after the answers so far, in order.
   */
  public List<Question> asked() {
    return page.asked(answers);
  }

  /** Reports that the current page was shown. */
  public void begin() {
    listener.shown(page, asked());
  }

  /** Records that a question of the page came into view; only the first time counts. */
  public void saw(Question question) {
    seen.putIfAbsent(question.id(), System.nanoTime());
  }

  /**
   * Records an answer.
   *
   * @param settled whether the answer is final; false while the participant is typing
   * @param at time of the answer, by {@link System#nanoTime}
   */
  public void answer(Question question, Answer answer, boolean settled, long at) {
    int place = asked().indexOf(question) + 1;
    answers.put(question.id(), answer);
    long since = seen.computeIfAbsent(question.id(), first -> at);
    if (settled) {
      listener.answered(question, answer, Math.max(0, (at - since) / 1_000_000), place);
    }
  }

  /** Returns how many questions of the page still need an answer. */
  public int open() {
    return (int)
        asked().stream().filter(question -> !question.complete(answer(question), wording)).count();
  }

  /**
   * Returns how many questions of the page need an answer: an optional one does not, unless its
   * answer is begun.
   */
  public int needed() {
    return (int)
        asked().stream()
            .filter(
                question -> !question.optional() || !question.complete(answer(question), wording))
            .count();
  }

  /** Returns whether an answer of the page refuses consent. */
  public boolean refuses() {
    return asked().stream().anyMatch(question -> question.refuses(answer(question)));
  }

  /** Returns whether the participant may go on from the page. */
  public boolean mayGoOn() {
    return open() == 0 && !refuses();
  }

  /**
   * Turns the page.
   *
   * @param by 1 for the next page, -1 for the previous one
   * @return whether there is such a page; if not, the page stays
   */
  public boolean turn(int by) {
    List<QuestionnairePage> shown = pages();
    int to = shown.indexOf(page) + by;
    if (to < 0 || to >= shown.size()) {
      return false;
    }
    page = shown.get(to);
    seen.clear();
    return true;
  }
}
