package org.selectiverenderer.app.session;

import com.formdev.flatlaf.FlatLightLaf;
import java.io.IOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.app.window.ControlWindow;
import org.selectiverenderer.app.window.MonitorBounds;
import org.selectiverenderer.app.window.QuestionnaireWindow;
import org.selectiverenderer.app.window.SessionEndWatcher;
import org.selectiverenderer.app.window.ThanksWindow;
import org.selectiverenderer.base.natives.FlatLafLibrary;
import org.selectiverenderer.render.window.Monitor;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/** The user interface of a session in Swing windows. */
public final class SwingSessionUi implements SessionUi {
  private final ParticipantMessages wording;
  private final MonitorBounds desk;
  private final MonitorBounds reading;
  private @Nullable ControlWindow control;
  private @Nullable Narration narration;

  /**
   * @param stage the monitors on which the windows open
   */
  public SwingSessionUi(ParticipantMessages wording, OperatorViewSettings stage) {
    this.wording = wording;
    desk = place(stage.monitor());
    reading = place(stage.reading());
    FlatLafLibrary.use(SwingSessionUi.class);
    FlatLightLaf.setup();
  }

  private static MonitorBounds place(Optional<Monitor> monitor) {
    return monitor
        .map(at -> new MonitorBounds(at.screen(), at.x(), at.y(), at.width(), at.height()))
        .orElse(MonitorBounds.USUAL);
  }

  @Override
  public void open(ExperimenterControls controls) {
    control = ControlWindow.open(controls, desk);
  }

  @Override
  public void narrate(Narration player) {
    narration = player;
  }

  @Override
  public Optional<String> form(Session session, ExperimenterControls controls) throws IOException {
    SessionStep step = new SessionStep.Form();
    AnswerRecorder answers = new AnswerRecorder(session, step);
    return ask(session, step, controls, answers, true)
        ? Optional.of(session.questionnaire(step).set(Question.Sets.AGE, answers.all()).orElse(""))
        : Optional.empty();
  }

  @Override
  public boolean questions(
      Session session, SessionStep.Questions step, ExperimenterControls controls)
      throws IOException {
    return ask(session, step, controls, new AnswerRecorder(session, step), false);
  }

  /**
   * Asks page by page.
   *
   * @return whether all is answered; otherwise the session has ended or the participant has refused
   */
  private boolean ask(
      Session session,
      SessionStep step,
      ExperimenterControls controls,
      AnswerRecorder answers,
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
            new SessionEndWatcher(() -> controls.aborted() || answers.failed(), controls::askAbort),
            reading,
            Optional.ofNullable(narration));
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
