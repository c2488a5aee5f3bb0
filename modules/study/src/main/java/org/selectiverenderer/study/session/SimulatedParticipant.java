package org.selectiverenderer.study.session;

import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;

/**
 * A simulated participant for unattended sessions. The answers are random, but depend on the truth,
 * so that an analysis finds an effect; the same participant of the same study always gives the same
 * answers.
 */
public final class SimulatedParticipant {
  /** Shortest response time in milliseconds, and the range above it. */
  private static final int QUICKEST = 400;

  private static final int SPREAD = 4000;

  private final Random random;
  private final ParticipantMessages wording;

  public SimulatedParticipant(long seed, String participant, ParticipantMessages wording) {
    random = new Random((seed ^ participant.hashCode()) * 0x9E3779B97F4A7C15L);
    this.wording = wording;
  }

  /** Receives the answers. */
  public interface Listener {
    /** A page was reached. */
    void page(QuestionnairePage page, Map<String, Answer> answers) throws java.io.IOException;

    /**
     * A question was answered.
     *
     * @param milliseconds response time
     * @param place of the question on its page, from 1
     */
    void answer(Question question, Answer answer, long milliseconds, int place)
        throws java.io.IOException;
  }

  /**
   * Answers the open questions page by page. An earlier person may have answered some, perhaps
   * incompletely.
   *
   * @param known answers so far
   */
  public void answer(Questionnaire questionnaire, Map<String, Answer> known, Listener listener)
      throws java.io.IOException {
    Map<String, Answer> answers = new HashMap<>(known);
    for (QuestionnairePage page : questionnaire.pages()) {
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
