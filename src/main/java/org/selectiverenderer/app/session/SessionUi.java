package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/**
 * The user interface of a session towards participant and experimenter: in windows, or simulated
 * for tests.
 */
public interface SessionUi extends AutoCloseable {
  /** Gives the experimenter the controls. */
  void open(ExperimenterControls controls);

  /**
   * Takes the player of the audio of pages; is called before anything is asked. Without a call
   * pages are silent.
   */
  default void narrate(Narration narration) {
    // A user interface without pages plays nothing.
  }

  /**
   * Asks for age and consent.
   *
   * @return the age band; empty when the participant does not take part, or the experimenter has
   *     ended the session
   */
  Optional<String> form(Session session, ExperimenterControls controls) throws IOException;

  /**
   * Asks the questions of a step until all are answered; each answer is passed to the session.
   *
   * @return whether all are answered; otherwise the experimenter has ended the session
   */
  boolean questions(Session session, SessionStep.Questions step, ExperimenterControls controls)
      throws IOException;

  /** Thanks the participant at the end of the session. */
  void thanks(Session session);

  @Override
  void close();
}
