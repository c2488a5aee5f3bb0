package org.selectiverenderer.experiment.session;

import java.util.Random;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.QuestionItem;
import org.selectiverenderer.experiment.study.QuestionKind;

/**
 * Who takes part in an unattended session: answers at random but not quite, so that an analysis has
 * something to find, and turns round while looking. The same participant of the same study always
 * answers alike.
 */
public final class SimulatedParticipant {
  /** Chance of yes to an object that was there; d' is about 1.35. */
  private static final double HIT = 0.75;

  private static final double FALSE_ALARM = 0.25;

  private final Random random;

  public SimulatedParticipant(long seed, String participant) {
    random = new Random((seed ^ participant.hashCode()) * 0x9E3779B97F4A7C15L);
  }

  /** An answer to a question. */
  public Answer answer(QuestionKind kind, QuestionItem item) {
    if (kind == QuestionKind.EXPECTANCY) {
      return new Answer(Integer.toString(1 + random.nextInt(6)), 0);
    }
    boolean yes = random.nextDouble() < (item.present() ? HIT : FALSE_ALARM);
    return new Answer(yes ? "yes" : "no", 1 + random.nextInt(5));
  }
}
