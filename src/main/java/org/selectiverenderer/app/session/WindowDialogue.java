package org.selectiverenderer.app.session;

import com.formdev.flatlaf.FlatLightLaf;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.experiment.session.OperatorControls;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionStep;
import org.selectiverenderer.experiment.window.ControlWindow;
import org.selectiverenderer.experiment.window.DesktopPlace;
import org.selectiverenderer.experiment.window.FormWindow;
import org.selectiverenderer.experiment.window.QuestionnaireWindow;
import org.selectiverenderer.experiment.window.SessionEnd;
import org.selectiverenderer.experiment.window.ThanksWindow;
import org.selectiverenderer.runtime.render.window.Monitor;

/** Participant and experimenter sit before windows. */
public final class WindowDialogue implements SessionDialogue {
  private final Wording wording;
  private final Optional<DesktopPlace> place;
  private @Nullable ControlWindow control;

  /**
   * @param operator the operator's monitor; empty for wherever the desktop puts windows
   */
  public WindowDialogue(Wording wording, Optional<Monitor> operator) {
    this.wording = wording;
    place =
        operator.map(at -> new DesktopPlace(at.screen(), at.x(), at.y(), at.width(), at.height()));
    FlatLightLaf.setup();
  }

  @Override
  public void open(OperatorControls controls) {
    control = ControlWindow.open(controls, place);
  }

  @Override
  public Optional<String> form(Session session, OperatorControls controls) {
    return FormWindow.ask(
        session.folder().participant(),
        wording,
        new SessionEnd(controls::aborted, controls::askAbort));
  }

  @Override
  public boolean questions(Session session, SessionStep.Questions step, OperatorControls controls)
      throws IOException {
    AtomicReference<@Nullable IOException> failure = new AtomicReference<>();
    boolean through =
        QuestionnaireWindow.ask(
            session.screen(step),
            wording,
            session.answers(step),
            (item, answer) -> {
              try {
                session.answer(step, item, answer);
              } catch (IOException e) {
                failure.set(e);
              }
            },
            new SessionEnd(() -> controls.aborted() || failure.get() != null, controls::askAbort));
    IOException failed = failure.get();
    if (failed != null) {
      throw failed;
    }
    return through;
  }

  @Override
  public void thanks(Session session) {
    ThanksWindow.show(wording);
  }

  @Override
  public void close() {
    if (control != null) {
      control.close();
    }
  }
}
