package org.selectiverenderer.app.session;

import com.formdev.flatlaf.FlatLightLaf;
import java.io.IOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.experiment.questionnaire.Question;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.experiment.session.OperatorControls;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionStep;
import org.selectiverenderer.experiment.window.ControlWindow;
import org.selectiverenderer.experiment.window.DesktopPlace;
import org.selectiverenderer.experiment.window.QuestionnaireWindow;
import org.selectiverenderer.experiment.window.SessionEnd;
import org.selectiverenderer.experiment.window.ThanksWindow;
import org.selectiverenderer.runtime.render.window.Monitor;

/** The user interface of a session in Swing windows. */
public final class WindowDialogue implements SessionDialogue {
  private final Wording wording;
  private final DesktopPlace desk;
  private final DesktopPlace reading;
  private @Nullable ControlWindow control;

  /**
   * @param stage the monitors on which the windows open
   */
  public WindowDialogue(Wording wording, SessionStage stage) {
    this.wording = wording;
    desk = place(stage.monitor());
    reading = place(stage.reading());
    FlatLightLaf.setup();
  }

  private static DesktopPlace place(Optional<Monitor> monitor) {
    return monitor
        .map(at -> new DesktopPlace(at.screen(), at.x(), at.y(), at.width(), at.height()))
        .orElse(DesktopPlace.USUAL);
  }

  @Override
  public void open(OperatorControls controls) {
    control = ControlWindow.open(controls, desk);
  }

  @Override
  public Optional<String> form(Session session, OperatorControls controls) throws IOException {
    SessionStep step = new SessionStep.Form();
    ToldAnswers answers = new ToldAnswers(session, step);
    return ask(session, step, controls, answers, true)
        ? Optional.of(session.questionnaire(step).set(Question.Sets.AGE, answers.all()).orElse(""))
        : Optional.empty();
  }

  @Override
  public boolean questions(Session session, SessionStep.Questions step, OperatorControls controls)
      throws IOException {
    return ask(session, step, controls, new ToldAnswers(session, step), false);
  }

  /**
   * Asks page by page.
   *
   * @return whether all is answered; otherwise the session has ended or the participant has refused
   */
  private boolean ask(
      Session session,
      SessionStep step,
      OperatorControls controls,
      ToldAnswers answers,
      boolean mayRefuse)
      throws IOException {
    boolean through =
        QuestionnaireWindow.ask(
            new QuestionnaireWindow.Asking(
                session.questionnaire(step),
                wording,
                session.folder().participant(),
                session.answers(step),
                session.lastPage(step),
                mayRefuse),
            answers,
            new SessionEnd(() -> controls.aborted() || answers.failed(), controls::askAbort),
            reading);
    answers.check();
    return through;
  }

  @Override
  public void thanks(Session session) {
    ThanksWindow.show(wording, reading);
  }

  @Override
  public void close() {
    if (control != null) {
      control.close();
    }
  }
}
