package org.selectiverenderer.app.threshold;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.experiment.threshold.ThresholdSession;
import org.selectiverenderer.experiment.threshold.ThresholdTrial;

/** Who answers the trials: a participant before a window, or nobody. */
public interface ThresholdDialogue extends AutoCloseable {
  /**
   * An answer.
   *
   * @param response one of the trial's choices, or {@link ThresholdTrial#NONE}
   * @param ms from when the trial was to be seen
   */
  record Given(String response, long ms) {}

  /**
   * Says what is to be done.
   *
   * @return false when it is to end
   */
  boolean introduce() throws InterruptedException;

  /** Shows a trial and waits for the answer; empty when it is to end. */
  Optional<Given> ask(ThresholdTrial trial, ThresholdSession session)
      throws IOException, InterruptedException;

  /** All is found. */
  void thanks();

  @Override
  void close();

  /**
   * Goes through a session's trials until all is found.
   *
   * @return whether it is; else somebody has ended it, and it can be continued
   * @throws IOException if an answer cannot be kept or a picture cannot be read
   */
  static boolean run(ThresholdSession session, ThresholdDialogue dialogue)
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
