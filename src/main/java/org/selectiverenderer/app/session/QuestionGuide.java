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
import org.selectiverenderer.app.headset.HeadsetAnswer;
import org.selectiverenderer.app.headset.PanelPlace;
import org.selectiverenderer.app.headset.PanelPointer;
import org.selectiverenderer.app.run.RunGuide;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.experiment.questionnaire.ButtonCourse;
import org.selectiverenderer.experiment.questionnaire.QuestionnaireCourse;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.experiment.session.OperatorControls;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionStep;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.openxr.SpacePose;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.camera.Mark;
import org.selectiverenderer.runtime.camera.Panel;
import org.selectiverenderer.runtime.render.window.KeyboardKey;
import org.selectiverenderer.runtime.viewer.ViewerMotion;

/**
 * Asks the questions of a step inside the headset until all are answered. The hand controllers give
 * the answers and do not move the viewer. Behind the questions the scene is dimmed, or black where
 * the questions are about it.
 */
final class QuestionGuide implements RunGuide {
  private static final double DIMMED = 0.8;

  /** Frames between two presses of a simulated participant. */
  private static final int PRESS = 5;

  private final Session session;
  private final SessionStep.Questions step;
  private final OperatorControls controls;
  private final HeadsetLayout layout;
  private final boolean dark;
  private final ToldAnswers told;
  private final QuestionSheet sheet;
  private final Random simulated;
  private @Nullable ButtonCourse buttons;
  private @Nullable PanelPlace place;
  private @Nullable World world;
  private Optional<SpacePose> aim = Optional.empty();
  private @Nullable Shown shown;
  private @Nullable SheetTarget lit;
  private boolean taken;
  private int frames;

  /** The sheet that was drawn last, and its placement in the world. */
  private record Shown(QuestionSheet.Sheet sheet, Matrix4dc place) {}

  /**
   * @param layout gives the scale of the participant in the scene
   * @param dark whether nothing of the scene may be seen
   * @throws IOException with a one-line message if a page's picture cannot be read
   */
  QuestionGuide(
      Session session,
      SessionStep.Questions step,
      OperatorControls controls,
      HeadsetLayout layout,
      boolean dark)
      throws IOException {
    this.session = session;
    this.step = step;
    this.controls = controls;
    this.layout = layout;
    this.dark = dark;
    told = new ToldAnswers(session, step);
    sheet =
        new QuestionSheet(
            session.material().wording(), PanelPictures.of(session.questionnaire(step)));
    simulated = new Random(session.material().study().seed() + step.id().hashCode());
  }

  /** Returns the recorder of the answers, whose failure is to be checked when the step is over. */
  ToldAnswers told() {
    return told;
  }

  /** Returns whether all questions are answered. */
  boolean through() {
    return buttons != null && buttons.over();
  }

  @Override
  public void opened(Walkthrough walk) {
    world = walk.world();
    place = new PanelPlace(walk.world(), layout);
  }

  /** Returns the course of the questions, which begins when they are first shown. */
  private ButtonCourse begun() {
    ButtonCourse known = buttons;
    if (known == null) {
      Wording wording = session.material().wording();
      known =
          new ButtonCourse(
              new QuestionnaireCourse(
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
  public void pointed(Optional<SpacePose> hand) {
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
    Optional<SheetTarget> target = at.flatMap(to -> target(to));
    SheetTarget was = lit;
    if (was != null && target.filter(now -> now == was).isPresent()) {
      lit = null; // Once only: the next target has not been pointed at yet.
      was.choose().run();
    }
  }

  private Optional<SheetTarget> target(Vector2d at) {
    Shown seen = shown;
    return seen == null ? Optional.empty() : seen.sheet.at(at.x, at.y);
  }

  private Optional<PanelPointer> pointer() {
    World known = world;
    return known == null ? Optional.empty() : aim.map(hand -> PanelPointer.of(known, layout, hand));
  }

  /** Returns the point of the page drawn last at which the hand points. */
  private Optional<Vector2d> point() {
    Shown seen = shown;
    return seen == null ? Optional.empty() : pointer().flatMap(ray -> ray.on(seen.place));
  }

  @Override
  public void answered(HeadsetAnswer answer) {
    ButtonCourse asking = buttons;
    if (asking == null || asking.over() || controls.paused()) {
      return;
    }
    if (answer == HeadsetAnswer.CHOOSE) {
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
  public List<Panel> panels() {
    PanelPlace where = place;
    if (where == null || controls.paused()) {
      shown = null;
      return List.of();
    }
    ButtonCourse asking = begun();
    if (session.options().unattended() && ++frames % PRESS == 0) {
      boolean written = asking.line().isPresent();
      boolean yes = asking.question().isEmpty() || written || simulated.nextBoolean();
      if (written && asking.written().isEmpty()) {
        asking.write(asking.line().orElseThrow().simulated(simulated));
      }
      answered(yes ? HeadsetAnswer.YES : HeadsetAnswer.NO);
    }
    QuestionSheet.Sheet drawn = sheet.of(asking, aim.isPresent());
    Matrix4dc stands = where.of(QuestionSheet.WIDTH, drawn.height(), QuestionSheet.metres());
    shown = new Shown(drawn, stands);
    List<Mark> marks = new ArrayList<>(drawn.marks());
    Optional<Vector2d> at = point().filter(to -> drawn.has(to.x, to.y));
    SheetTarget target = at.flatMap(this::target).orElse(null);
    lit = target;
    if (target != null) {
      marks.addAll(target.lit());
    }
    at.ifPresent(to -> marks.add(QuestionSheet.spot(to.x, to.y)));
    List<Panel> panels = new ArrayList<>(List.of(new Panel(marks, stands)));
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
    return controls.aborted() || told.failed() || through();
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
    ButtonCourse asking = buttons;
    if (asking == null) {
      return step.id();
    }
    QuestionnaireCourse course = asking.course();
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
