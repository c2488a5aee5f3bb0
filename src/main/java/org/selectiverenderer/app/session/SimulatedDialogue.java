package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.experiment.questionnaire.Answer;
import org.selectiverenderer.experiment.questionnaire.QuestionItem;
import org.selectiverenderer.experiment.questionnaire.Screen;
import org.selectiverenderer.experiment.session.OperatorControls;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionStep;
import org.selectiverenderer.experiment.session.SimulatedParticipant;

/** Nobody sits there: a simulated participant answers at once. */
public final class SimulatedDialogue implements SessionDialogue {
  @Override
  public void open(OperatorControls controls) {
    // There is no experimenter either.
  }

  @Override
  public Optional<String> form(Session session, OperatorControls controls) {
    return Optional.of("simulated");
  }

  @Override
  public boolean questions(Session session, SessionStep.Questions step, OperatorControls controls)
      throws IOException {
    Screen screen = session.screen(step);
    SimulatedParticipant participant =
        new SimulatedParticipant(
            session.material().study().seed() + step.id().hashCode(),
            session.folder().participant());
    Map<String, Answer> known = session.answers(step);
    for (QuestionItem item : screen.items()) {
      Answer answer = participant.answer(step.kind(), item);
      // Whoever sat there before may have given half an answer.
      if (!known.getOrDefault(item.object(), Answer.NONE).complete(screen.withConfidence())) {
        session.answer(step, item, answer);
      }
    }
    return true;
  }

  @Override
  public void thanks(Session session) {
    // Nobody is there to be thanked.
  }

  @Override
  public void close() {
    // There is no window.
  }
}
