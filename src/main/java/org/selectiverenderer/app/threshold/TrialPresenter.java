package org.selectiverenderer.app.threshold;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.study.threshold.ThresholdSession;
import org.selectiverenderer.study.threshold.ThresholdTrial;

/**
 * Presents the trials of a threshold pilot and returns the answers: to a participant in a window,
 * or to a simulated observer.
 */
public interface TrialPresenter extends AutoCloseable {
  /**
   * An answer.
   *
   * @param response one of the trial's choices, or {@link ThresholdTrial#NONE}
   * @param ms response time in milliseconds from the onset of the trial
   */
  record Given(String response, long ms) {}

  /**
   * Shows the instructions.
   *
   * @return false when the session is to end
   */
  boolean introduce() throws InterruptedException;

  /** Shows a trial and waits for the answer; empty when the session is to end. */
  Optional<Given> ask(ThresholdTrial trial, ThresholdSession session)
      throws IOException, InterruptedException;

  /** Thanks the participant when all thresholds are found. */
  void thanks();

  @Override
  void close();

  /**
   * Runs a session's trials until all thresholds are found.
   *
   * @return whether all are found; otherwise the session was ended early and can be continued
   * @throws IOException if an answer cannot be written or a picture cannot be read
   */
  static boolean run(ThresholdSession session, TrialPresenter dialogue)
      throws IOException, InterruptedException {
    boolean goesOn = session.next().isEmpty() || dialogue.introduce();
    Optional<ThresholdTrial> trial = session.next();
    while (goesOn && trial.isPresent()) {
      Optional<Given> given = dialogue.ask(trial.get(), session);
      goesOn = given.isPresent();
      if (given.isPresent()) {
        session.answer(trial.get(), given.get().response(), given.get().ms());
        trial = session.next();
      }
    }
    if (goesOn) {
      dialogue.thanks();
    } else {
      session.abort();
    }
    return goesOn;
  }
}
