package org.selectiverenderer.experiment.session;

import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.Page;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Questionnaire;
import org.selectiverenderer.experiment.questionnaire.Wording;

/**
 * Who takes part in an unattended session: answers at random but not quite, so that an analysis has
 * something to find, and turns round while looking. The same participant of the same study always
 * answers alike.
 */
public final class SimulatedParticipant {
  /** Milliseconds of the quickest answer, and how much others may take beyond it. */
  private static final int QUICKEST = 400;

  private static final int SPREAD = 4000;

  private final Random random;
  private final Wording wording;

  public SimulatedParticipant(long seed, String participant, Wording wording) {
    random = new Random((seed ^ participant.hashCode()) * 0x9E3779B97F4A7C15L);
    this.wording = wording;
  }

  /** Hears the answers. */
  public interface Listener {
    /** A page is met. */
    void page(Page page, Map<String, Answer> answers) throws java.io.IOException;

    /**
     * A question is answered.
     *
     * @param milliseconds that it took
     * @param place of the question on its page, from 1
     */
    void answer(Question question, Answer answer, long milliseconds, int place)
        throws java.io.IOException;
  }

  /**
   * Answers page by page what is not yet answered; whoever sat there before may have given half an
   * answer.
   *
   * @param known answers so far
   */
  public void answer(Questionnaire questionnaire, Map<String, Answer> known, Listener listener)
      throws java.io.IOException {
    Map<String, Answer> answers = new HashMap<>(known);
    for (Page page : questionnaire.pages()) {
      if (!questionnaire.shown(answers).contains(page)) {
        continue;
      }
      listener.page(page, answers);
      for (Question question : page.questions()) {
        Answer answer = answer(question);
        long took = QUICKEST + random.nextInt(SPREAD);
        int place = page.asked(answers).indexOf(question) + 1;
        boolean open =
            place > 0
                && !answers
                    .getOrDefault(question.id(), Answer.NONE)
                    .complete(question.kind().fields(wording).size() > 1);
        if (open) {
          answers.put(question.id(), answer);
          listener.answer(question, answer, took, place);
        }
      }
    }
  }

  private Answer answer(Question question) {
    Answer answer = question.kind().simulated(wording, random);
    return question.must().map(Answer::of).orElse(answer);
  }
}
