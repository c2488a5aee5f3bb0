package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.head.ChainTracker;
import org.selectiverenderer.app.headset.HeadsetLink;
import org.selectiverenderer.app.run.WindowChain;
import org.selectiverenderer.experiment.session.OperatorControls;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionStep;

/** Runs the remaining steps of a session. */
public final class SessionRunner {
  /** The outcome of a session. */
  public enum Outcome {
    FINISHED,
    ABORTED,
    REFUSED
  }

  private final Session session;
  private final SessionDialogue dialogue;
  private final ShownSteps shown;
  private final OperatorControls controls;
  private final ChainTracker tracker;
  private final Consumer<String> message;
  private final Optional<SessionHeadset> headset;

  /** Creates a runner without a headset. */
  public SessionRunner(
      Session session,
      SessionDialogue dialogue,
      SessionShow settings,
      ChainTracker tracker,
      Consumer<String> message) {
    this(session, dialogue, settings, tracker, Optional.empty(), message);
  }

  /**
   * @param settings how scenes are shown
   * @param tracker opened when a scene is first shown, unless it is open; stays open
   * @param headset the headset in which they are shown; empty for other displays
   * @param message receives messages about a display that is not available as requested
   */
  public SessionRunner(
      Session session,
      SessionDialogue dialogue,
      SessionShow settings,
      ChainTracker tracker,
      Optional<SessionHeadset> headset,
      Consumer<String> message) {
    this.headset = headset;
    this.session = session;
    this.dialogue = dialogue;
    this.tracker = tracker;
    this.message = message;
    controls = new OperatorControls(session.journal());
    shown = new ShownSteps(session, settings, controls);
  }

  /**
   * Runs the remaining steps.
   *
   * @throws IOException if something cannot be shown or written; what is finished is kept
   * @throws InterruptedException if the thread is interrupted
   */
  public Outcome run() throws IOException, InterruptedException {
    dialogue.open(controls);
    while (true) {
      List<SessionStep> left = session.remaining();
      if (left.isEmpty()) {
        session.end();
        dialogue.thanks(session);
        return Outcome.FINISHED;
      }
      SessionStep step = left.get(0);
      controls.status(step.id());
      if (step instanceof SessionStep.Form) {
        form(step);
        if (session.refused()) {
          return Outcome.REFUSED;
        }
      } else if (step instanceof SessionStep.Questions questions && !shown.shows(step)) {
        session.began(step, false);
        if (dialogue.questions(session, questions, controls)) {
          session.finished(step, Map.of());
        } else {
          controls.abort();
        }
      } else {
        show();
        // Closing a window ends the session, as the experimenter's abort does.
        if (session.remaining().contains(step) || shown.wanted()) {
          controls.abort();
        }
      }
      if (controls.aborted()) {
        session.abort(step.id());
        return Outcome.ABORTED;
      }
    }
  }

  private void show() throws IOException, InterruptedException {
    if (headset.isEmpty()) {
      WindowChain.show(shown, tracker, Optional.empty(), message);
      return;
    }
    try (HeadsetLink worn = headset.get().connect()) {
      WindowChain.show(shown, tracker, Optional.of(worn), message);
    }
  }

  private void form(SessionStep step) throws IOException {
    session.began(step, false);
    Optional<String> age = dialogue.form(session, controls);
    if (age.isPresent()) {
      session.assign(age.get());
      session.finished(step, Map.of());
    } else if (!controls.aborted()) {
      session.refuse();
    }
  }
}
