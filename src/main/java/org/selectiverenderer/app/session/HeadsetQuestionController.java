package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.joml.Matrix4dc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.headset.ControllerCommand;
import org.selectiverenderer.app.headset.PanelPlacement;
import org.selectiverenderer.app.headset.PanelPointerRay;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.app.run.RunController;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.openxr.XrPose;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.QuestionnaireProgress;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Asks the questions of a step inside the headset until all are answered. The hand controllers give
 * the answers and do not move the viewer. Behind the questions the scene is dimmed, or black where
 * the questions are about it.
 */
final class HeadsetQuestionController implements RunController {
  private static final double DIMMED = 0.8;

  /** Frames between two presses of a simulated participant. */
  private static final int PRESS = 5;

  private final Session session;
  private final SessionStep.Questions step;
  private final ExperimenterControls controls;
  private final HeadsetLayout layout;
  private final boolean dark;
  private final AnswerRecorder told;
  private final QuestionPanelRenderer sheet;
  private final Random simulated;
  private @Nullable ButtonQuestionnaireController buttons;
  private @Nullable PanelPlacement place;
  private @Nullable World world;
  private Optional<XrPose> aim = Optional.empty();
  private @Nullable Shown shown;
  private @Nullable PointerTarget lit;
  private boolean taken;
  private int frames;

  /** The sheet that was drawn last, and its placement in the world. */
  private final Narration narration;

  private record Shown(QuestionPanelRenderer.Sheet sheet, Matrix4dc place) {}

  /**
   * @param layout gives the scale of the participant in the scene
   * @param dark whether nothing of the scene may be seen
   * @param narration plays the audio of the pages
   * @throws IOException with a one-line message if a page's picture cannot be read
   */
  HeadsetQuestionController(
      Session session,
      SessionStep.Questions step,
      ExperimenterControls controls,
      HeadsetLayout layout,
      boolean dark,
      Narration narration)
      throws IOException {
    this.session = session;
    this.step = step;
    this.controls = controls;
    this.layout = layout;
    this.dark = dark;
    this.narration = narration;
    told = new AnswerRecorder(session, step);
    sheet =
        new QuestionPanelRenderer(
            session.material().wording(), PanelImageLoader.of(session.questionnaire(step)));
    simulated = new Random(session.material().study().seed() + step.id().hashCode());
  }

  /** Returns the recorder of the answers, whose failure is to be checked when the step is over. */
  AnswerRecorder told() {
    return told;
  }

  /** Returns whether all questions are answered. */
  boolean through() {
    return buttons != null && buttons.over();
  }

  @Override
  public void opened(Walkthrough walk) {
    world = walk.world();
    place = new PanelPlacement(walk.world(), layout);
  }

  /** Returns the course of the questions, which begins when they are first shown. */
  private ButtonQuestionnaireController begun() {
    ButtonQuestionnaireController known = buttons;
    if (known == null) {
      ParticipantMessages wording = session.material().wording();
      known =
          new ButtonQuestionnaireController(
              new QuestionnaireProgress(
                  session.questionnaire(step),
                  wording,
                  session.answers(step),
                  session.lastPage(step),
                  told),
              wording);
      buttons = known;
    }
    return known;
  }

  @Override
  public void pointed(Optional<XrPose> hand) {
    aim = hand;
    taken = false;
  }

  /**
   * Chooses the highlighted target; other meanings of the button are ignored while the hand points
   * at the page.
   */
  private void choose() {
    Optional<Vector2d> at = point();
    Shown seen = shown;
    taken = seen != null && at.filter(to -> seen.sheet.has(to.x, to.y)).isPresent();
    Optional<PointerTarget> target = at.flatMap(to -> target(to));
    PointerTarget was = lit;
    if (was != null && target.filter(now -> now == was).isPresent()) {
      lit = null; // Once only: the next target has not been pointed at yet.
      was.choose().run();
    }
  }

  private Optional<PointerTarget> target(Vector2d at) {
    Shown seen = shown;
    return seen == null ? Optional.empty() : seen.sheet.at(at.x, at.y);
  }

  private Optional<PanelPointerRay> pointer() {
    World known = world;
    return known == null
        ? Optional.empty()
        : aim.map(hand -> PanelPointerRay.of(known, layout, hand));
  }

  /** Returns the point of the page drawn last at which the hand points. */
  private Optional<Vector2d> point() {
    Shown seen = shown;
    return seen == null ? Optional.empty() : pointer().flatMap(ray -> ray.on(seen.place));
  }

  @Override
  public void answered(ControllerCommand answer) {
    ButtonQuestionnaireController asking = buttons;
    if (asking == null || asking.over() || controls.paused()) {
      return;
    }
    if (answer == ControllerCommand.CHOOSE) {
      choose();
      return;
    }
    if (taken) {
      return;
    }
    switch (answer) {
      case YES -> asking.yes();
      case NO -> asking.no();
      case MORE -> asking.more();
      case LESS -> asking.less();
      case CHOOSE -> throw new AssertionError();
    }
  }

  @Override
  public List<WorldSpacePanel> panels() {
    PanelPlacement where = place;
    if (where == null || controls.paused()) {
      shown = null;
      return List.of();
    }
    ButtonQuestionnaireController asking = begun();
    if (session.options().unattended() && ++frames % PRESS == 0) {
      boolean filled = asking.simulate(simulated);
      boolean yes = asking.question().isEmpty() || filled || simulated.nextBoolean();
      answered(yes ? ControllerCommand.YES : ControllerCommand.NO);
    }
    QuestionPanelRenderer.Sheet drawn =
        sheet.of(asking, aim.isPresent() ? AnswerDevice.RAY : AnswerDevice.BUTTONS);
    Matrix4dc stands =
        where.of(QuestionPanelRenderer.WIDTH, drawn.height(), QuestionPanelRenderer.metres());
    shown = new Shown(drawn, stands);
    List<Primitive2D> marks = new ArrayList<>(drawn.marks());
    Optional<Vector2d> at = point().filter(to -> drawn.has(to.x, to.y));
    PointerTarget target = at.flatMap(this::target).orElse(null);
    lit = target;
    if (target != null) {
      marks.addAll(target.lit());
    }
    at.ifPresent(to -> marks.add(QuestionPanelRenderer.spot(to.x, to.y)));
    List<WorldSpacePanel> panels = new ArrayList<>(List.of(new WorldSpacePanel(marks, stands)));
    pointer()
        .ifPresent(
            ray ->
                panels.add(
                    ray.drawn(
                        at.map(to -> stands.transformPosition(new Vector3d(to.x, to.y, 0))))));
    return panels;
  }

  @Override
  public ViewerMotion motion(ViewerMotion users) {
    return (viewer, time, dt) -> {}; // The controllers give answers and do not move the viewer.
  }

  @Override
  public boolean walks() {
    return false;
  }

  @Override
  public boolean takeHeadingReset() {
    return controls.takeResetHeading();
  }

  @Override
  public void operatorKey(KeyboardKey key, boolean participants) {
    if (key == KeyboardKey.F8) {
      controls.pause(!controls.paused());
    }
  }

  @Override
  public boolean paused() {
    return controls.paused();
  }

  @Override
  public boolean over(double seconds) {
    controls.status(where());
    boolean over = controls.aborted() || told.failed() || through();
    if (over) {
      narration.hide();
    } else if (buttons != null) {
      narration.show(buttons.course().page().id(), buttons.course().page().audio());
    }
    return over;
  }

  @Override
  public double darkness(double seconds) {
    return dark || controls.paused() ? 1 : DIMMED;
  }

  @Override
  public boolean closing() {
    return !controls.askAbort();
  }

  private String where() {
    ButtonQuestionnaireController asking = buttons;
    if (asking == null) {
      return step.id();
    }
    QuestionnaireProgress course = asking.course();
    return "%s: %spage %d of %d, question %d of %d"
        .formatted(
            step.id(),
            controls.paused() ? "PAUSED, " : "",
            course.number() + 1,
            course.pages().size(),
            Math.min(asking.place(), course.asked().size()),
            course.asked().size());
  }

  @Override
  public List<String> operatorLines(double seconds) {
    return List.of("participant " + session.folder().participant(), where());
  }
}
