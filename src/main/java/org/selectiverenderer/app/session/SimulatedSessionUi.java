package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.study.session.SimulatedParticipant;

/** The user interface of an unattended session: a simulated participant answers at once. */
public final class SimulatedSessionUi implements SessionUi {
  @Override
  public void open(ExperimenterControls controls) {
    // There is no experimenter either.
  }

  @Override
  public Optional<String> form(Session session, ExperimenterControls controls) throws IOException {
    answer(session, new SessionStep.Form());
    return Optional.of("simulated");
  }

  @Override
  public boolean questions(
      Session session, SessionStep.Questions step, ExperimenterControls controls)
      throws IOException {
    answer(session, step);
    return true;
  }

  private static void answer(Session session, SessionStep step) throws IOException {
    new SimulatedParticipant(
            session.material().study().seed() + step.id().hashCode(),
            session.folder().participant(),
            session.material().wording())
        .answer(
            session.questionnaire(step),
            session.answers(step),
            new SimulatedParticipant.Listener() {
              @Override
              public void page(QuestionnairePage page, Map<String, Answer> answers) {
                session.shown(step, page, page.asked(answers));
              }

              @Override
              public void answer(Question question, Answer answer, long milliseconds, int place)
                  throws IOException {
                session.answer(step, question, answer, OptionalLong.of(milliseconds), place);
              }
            });
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
