package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.app.head.SharedHeadTracker;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.app.run.RunSequence;
import org.selectiverenderer.browser.sound.SoundDeviceLine;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/** Runs the remaining steps of a session. */
public final class SessionRunner {
  /** The outcome of a session. */
  public enum Outcome {
    FINISHED,
    ABORTED,
    REFUSED
  }

  private final Session session;
  private final SessionUi dialogue;
  private final SessionRunProvider shown;
  private final ExperimenterControls controls;
  private final SharedHeadTracker tracker;
  private final Consumer<String> message;
  private final Optional<SessionHeadset> headset;
  private final Narration narration;

  /** Creates a runner without a headset. */
  public SessionRunner(
      Session session,
      SessionUi dialogue,
      SessionDisplaySettings settings,
      SharedHeadTracker tracker,
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
      SessionUi dialogue,
      SessionDisplaySettings settings,
      SharedHeadTracker tracker,
      Optional<SessionHeadset> headset,
      Consumer<String> message) {
    this.headset = headset;
    this.session = session;
    this.dialogue = dialogue;
    this.tracker = tracker;
    this.message = message;
    Study study = session.material().study();
    controls =
        new ExperimenterControls(
            session.journal(), study.streams().wanted() || study.triggers().isPresent());
    narration = new Narration(SoundDeviceLine::open, System::nanoTime, this::warn);
    shown = new SessionRunProvider(session, settings, controls, narration);
  }

  /**
   * Runs the remaining steps.
   *
   * @throws IOException if something cannot be shown or written; what is finished is kept
   * @throws InterruptedException if the thread is interrupted
   */
  public Outcome run() throws IOException, InterruptedException {
    try (narration) {
      dialogue.open(controls);
      dialogue.narrate(narration);
      return steps();
    }
  }

  private void warn(String sentence) {
    session.journal().tell("problem", Map.of("text", sentence));
    message.accept(sentence);
  }

  private Outcome steps() throws IOException, InterruptedException {
    while (true) {
      List<SessionStep> open = session.remaining();
      if (open.isEmpty()) {
        session.end();
        dialogue.thanks(session);
        return Outcome.FINISHED;
      }
      SessionStep step = open.get(0);
      controls.status(step.id());
      controls.alarm("");
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
        shown.chainBegins();
        show();
        // Closing a window ends the session, as the experimenter's abort does.
        boolean left = session.remaining().contains(step) || shown.wanted();
        if (left && !shown.reopens()) {
          controls.abort();
        }
      }
      if (controls.aborted()) {
        // Several steps may have been shown since this one.
        session.abort();
        return Outcome.ABORTED;
      }
    }
  }

  private void show() throws IOException, InterruptedException {
    if (headset.isEmpty()) {
      RunSequence.show(shown, tracker, Optional.empty(), message);
      return;
    }
    try (HeadsetConnection worn = headset.get().connect()) {
      RunSequence.show(shown, tracker, Optional.of(worn), message);
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
