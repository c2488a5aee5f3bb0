package org.selectiverenderer.app.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.headset.ControllerCommand;
import org.selectiverenderer.app.headset.PanelPlacement;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.app.run.RunController;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.WorldSpacePanel;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialCourse;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialResult;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Controls the run of a trial: goes through its phases, sets the choices of Switches as exposures
 * begin, and takes the response. There are no fades, so that durations are those of the study.
 *
 * <p>A response is timed from the frame in which the phase began to be drawn to the key's event of
 * the window system; the picture reaches the eyes later, by the latency of the display.
 */
final class TrialController implements RunController {
  /** Text of the scene's event that ends an exposure. */
  static final String END = "end-trial";

  private static final double NANO = 1e-9;

  private final Session session;
  private final SessionStep.OneTrial step;
  private final ExperimenterControls controls;
  private final OperatorViewSettings stage;
  private final Optional<HeadsetLayout> headset;
  private final Consumer<Problem> problem;
  private final TrialCourse course;
  private final TrialPages pages = new TrialPages();
  private final SimulatedResponder simulated;
  private final Map<String, TrialQuestions> questions = new HashMap<>();
  private final List<Map<String, Object>> shown = new ArrayList<>();
  private final AtomicReference<@Nullable IOException> failure = new AtomicReference<>();
  private @Nullable Walkthrough walk;
  private @Nullable PanelPlacement place;
  private final Narration narration;
  private int frames;
  private int phasesBegun;
  private double lastTime;
  private long lastNanos;

  /**
   * @param rest whether the participant may rest before the trial
   * @param headset gives the scale of a headset's user; empty for windows
   * @param narration plays the audio of instructions and questions
   * @param problem receives warnings for the experimenter
   * @throws IOException with a one-line message if a questionnaire's picture cannot be read
   */
  TrialController(
      Session session,
      SessionStep.OneTrial step,
      boolean rest,
      ExperimenterControls controls,
      OperatorViewSettings stage,
      Optional<HeadsetLayout> headset,
      Narration narration,
      Consumer<Problem> problem)
      throws IOException {
    this.session = session;
    this.step = step;
    this.controls = controls;
    this.stage = stage;
    this.headset = headset;
    this.problem = problem;
    this.narration = narration;
    step.trial().phases().forEach(this::load);
    Trial trial = rest ? withRest(step.trial()) : step.trial();
    course = new TrialCourse(trial, this::seconds, new Recorder());
    simulated =
        new SimulatedResponder(session.material().study().seed() + step.id().hashCode(), course);
    for (TrialPhase phase : trial.phases()) {
      if (phase instanceof TrialPhase.Questions asked) {
        questions.put(
            asked.questionnaire(),
            new TrialQuestions(
                session,
                step,
                session
                    .material()
                    .inTrials(asked.questionnaire())
                    .orElseThrow()
                    .ordered(session.material().study().seed(), session.folder().participant()),
                headset.isPresent() ? AnswerDevice.BUTTONS : AnswerDevice.KEYBOARD));
      }
    }
  }

  private Trial withRest(Trial trial) {
    List<TrialPhase> phases = new ArrayList<>();
    phases.add(new TrialPhase.Instruction(session.material().wording().of("trial.rest")));
    phases.addAll(trial.phases());
    return trial.with(phases);
  }

  /** Returns the duration of an exposure, shortened in tests. */
  private double seconds(TrialPhase.Exposure exposure) {
    OptionalDouble planned = session.material().study().seconds(step.trial(), exposure);
    OptionalDouble shortened = session.options().exposure();
    double most = shortened.orElse(Double.POSITIVE_INFINITY);
    return Math.min(most, planned.orElse(Double.POSITIVE_INFINITY));
  }

  SessionStep.OneTrial step() {
    return step;
  }

  /** Returns the result of the trial, once it is over. */
  TrialResult result() {
    return course.result();
  }

  /** Returns whether all phases have been shown. */
  boolean through() {
    return course.over();
  }

  /** Returns the phases that were shown, with their times, as members of an event. */
  List<Map<String, Object>> shown() {
    return List.copyOf(shown);
  }

  /**
   * Throws the failure of the trial, if there was one.
   *
   * @throws IOException if an answer could not be written, or the scene lacks what the trial names
   */
  void check() throws IOException {
    IOException failed = failure.get();
    if (failed != null) {
      throw failed;
    }
    for (TrialQuestions asked : questions.values()) {
      asked.recorder().check();
    }
  }

  @Override
  public void opened(Walkthrough opened) {
    walk = opened;
    headset.ifPresent(layout -> place = new PanelPlacement(opened.world(), layout));
    step.trial().settings().headlight().ifPresent(opened.world()::headlight);
    session
        .material()
        .study()
        .viewpoint(step.trial())
        .ifPresent(
            name ->
                opened.world().views().viewpoints().stream()
                    .filter(node -> name.equals(node.name()))
                    .findFirst()
                    .ifPresent(opened.world().views()::goTo));
    hold(step.trial().settings().choices());
    opened.listen(this::marked);
  }

  private void hold(Map<String, Integer> choices) {
    Walkthrough scene = walk;
    if (scene == null || choices.isEmpty()) {
      return;
    }
    Set<String> missing = scene.hold(choices);
    if (!missing.isEmpty()) {
      failure.compareAndSet(
          null,
          new IOException(
              "%s: the scene has no Switch with the DEF '%s', whose choice the trial %s sets"
                  .formatted(scene.world().scene().url(), missing.iterator().next(), step.id())));
    }
  }

  /** Handles an event that the scene marks. */
  private void marked(String text) {
    session.journal().tell("scene-event", Map.of("step", step.id(), "text", text, "mono", now()));
    if (text.equals(END)) {
      course.sceneEnds();
    }
  }

  private static double now() {
    return DecimalRounding.to(6, System.nanoTime() * NANO);
  }

  @Override
  public ViewerMotion motion(ViewerMotion users) {
    ParticipantMotion motion = new ParticipantMotion(session, problem);
    Walkthrough scene = walk;
    Study study = session.material().study();
    Optional<Study.Area> area = step.trial().settings().area().flatMap(study::area);
    if (scene == null) {
      return motion.free(users);
    }
    ViewerMotion bounded =
        motion.within(
            scene,
            area.map(study::stay).orElse(study.course().stay()),
            area.flatMap(Study.Area::within),
            "trial " + step.id(),
            users);
    return (viewer, time, dt) -> {
      if (exposing()) {
        bounded.move(viewer, time, dt);
      }
    };
  }

  private boolean exposing() {
    return course.phase().filter(TrialPhase.Exposure.class::isInstance).isPresent();
  }

  private void load(TrialPhase phase) {
    if (phase instanceof TrialPhase.Instruction instruction) {
      instruction.audio().ifPresent(narration::load);
    } else if (phase instanceof TrialPhase.Repeat repeat) {
      repeat.phases().forEach(this::load);
    }
  }

  /** Plays the audio of the phase, or of the page of its questions. */
  private void narrate() {
    if (controls.paused() || course.over() || controls.aborted()) {
      narration.hide();
    } else if (asked().isPresent()) {
      QuestionnairePage page = asked().get().page();
      narration.show(step.id() + '/' + phasesBegun + '/' + page.id(), page.audio());
    } else {
      narration.show(step.id() + '/' + phasesBegun, spoken());
    }
  }

  private Optional<Path> spoken() {
    return course
        .phase()
        .filter(TrialPhase.Instruction.class::isInstance)
        .flatMap(phase -> ((TrialPhase.Instruction) phase).audio());
  }

  @Override
  public boolean over(double seconds) {
    lastTime = seconds;
    lastNanos = System.nanoTime();
    // The first frame is slow because the scene is uploaded to the graphics card.
    if (++frames <= 2 || controls.paused()) {
      return controls.aborted();
    }
    course.frame(seconds);
    asked()
        .ifPresent(
            questions -> {
              questions.frame();
              if (questions.over()) {
                course.questionsAnswered();
              }
            });
    if (session.options().unattended()) {
      simulated.frame(seconds);
    }
    narrate();
    controls.status(status());
    return controls.aborted() || failure.get() != null || course.over();
  }

  private Optional<TrialQuestions> asked() {
    return course
        .phase()
        .filter(TrialPhase.Questions.class::isInstance)
        .map(phase -> questions.get(((TrialPhase.Questions) phase).questionnaire()));
  }

  @Override
  public boolean pressed(KeyboardKey key, String character, long nanos) {
    if (controls.paused() || key == KeyboardKey.F8) {
      return false;
    }
    if (asked().isPresent()) {
      asked().get().pressed(key, character);
      return true;
    }
    if (spoken().isPresent() && key.spelling().equals("r")) {
      narration.again();
      return true;
    }
    return course.key(key.spelling(), lastTime + (nanos - lastNanos) * NANO);
  }

  @Override
  public void answered(ControllerCommand answer) {
    if (controls.paused()) {
      return;
    }
    if (asked().isPresent()) {
      asked().get().answered(answer);
      return;
    }
    List<String> keys = course.keys();
    double time = lastTime + (System.nanoTime() - lastNanos) * NANO;
    if (spoken().isPresent() && answer == ControllerCommand.NO) {
      narration.again();
    } else if (keys.isEmpty()) {
      course.key("space", time);
    } else if (answer == ControllerCommand.YES || answer == ControllerCommand.CHOOSE) {
      course.key(keys.get(0), time);
    } else if (answer == ControllerCommand.NO && keys.size() > 1) {
      course.key(keys.get(1), time);
    }
  }

  @Override
  public void operatorKey(KeyboardKey key, boolean participants) {
    if (key == KeyboardKey.F8 && (!participants || stage.pointerKept())) {
      controls.pause(!controls.paused());
    }
  }

  @Override
  public boolean takeHeadingReset() {
    return controls.takeResetHeading();
  }

  @Override
  public boolean keepsPointer() {
    return stage.pointerKept() && !controls.paused() && !controls.asking() && !controls.aborted();
  }

  @Override
  public boolean blind() {
    return stage.blind();
  }

  @Override
  public void tracked(Optional<String> silent) {
    controls.alarm(silent.orElse(""));
  }

  @Override
  public boolean paused() {
    return controls.paused();
  }

  @Override
  public boolean closing() {
    return !controls.askAbort();
  }

  @Override
  public double darkness(double seconds) {
    return exposing() && !controls.paused() ? 0 : 1;
  }

  @Override
  public Optional<HeadFixedPage> page() {
    if (controls.paused() || course.phase().isEmpty()) {
      return Optional.empty();
    }
    TrialPhase phase = course.phase().get();
    if (phase instanceof TrialPhase.Instruction instruction) {
      return Optional.of(pages.text(instruction.text(), hint(instruction.audio().isPresent())));
    } else if (phase instanceof TrialPhase.Fixation) {
      return Optional.of(pages.fixation());
    } else if (phase instanceof TrialPhase.Feedback feedback) {
      return Optional.of(pages.line(course.feedback(feedback)));
    }
    return asked().map(TrialQuestions::sheet).map(pages::sheet);
  }

  private String hint(boolean audio) {
    ParticipantMessages wording = session.material().wording();
    if (headset.isPresent()) {
      return wording.of(audio ? "headset.again" : "headset.read");
    }
    return wording.of("trial.read") + (audio ? " " + wording.of("trial.again") : "");
  }

  @Override
  public List<WorldSpacePanel> panels() {
    PanelPlacement where = place;
    Optional<HeadFixedPage> page = page();
    if (where == null || page.isEmpty()) {
      return List.of();
    }
    Matrix4dc stands =
        where.of(page.get().width(), page.get().height(), QuestionPanelRenderer.metres());
    return List.of(new WorldSpacePanel(page.get().marks(), stands));
  }

  private String status() {
    return "%s: %s%s"
        .formatted(
            step.id(),
            controls.paused() ? "PAUSED, " : "",
            course.phase().map(TrialController::kind).orElse("over"));
  }

  private static String kind(TrialPhase phase) {
    return phase.getClass().getSimpleName().toLowerCase(Locale.ROOT);
  }

  @Override
  public List<String> operatorLines(double seconds) {
    return List.of("participant " + session.folder().participant(), status());
  }

  /** Records the phases, and sets the choices of exposures. */
  private final class Recorder implements TrialCourse.Listener {
    @Override
    public void began(TrialPhase phase, double time) {
      phasesBegun++;
      session.journal().signal(kind(phase) + "-began", step.id(), step.trial()::filled);
      if (phase instanceof TrialPhase.Exposure exposure) {
        Map<String, Integer> choices = new LinkedHashMap<>();
        exposure.choices().forEach((name, choice) -> choices.put(name, number(name, choice)));
        hold(choices);
        if (shown.stream().noneMatch(known -> "exposure".equals(known.get("phase")))) {
          session
              .journal()
              .tell("shown", Map.of("step", step.id(), "t", DecimalRounding.to(3, time)));
        }
      }
    }

    @Override
    public void responded() {
      session.journal().signal("response", step.id(), step.trial()::filled);
    }

    private int number(String name, String choice) {
      if (choice.matches("-1|\\d{1,6}")) {
        return Integer.parseInt(choice);
      }
      failure.compareAndSet(
          null,
          new IOException(
              "%s: '%s' is no choice of the Switch %s in the trial %s; write a whole number, or -1 for none"
                  .formatted(
                      SourceLocation.of(session.material().study().file().toString()),
                      choice,
                      name,
                      step.id())));
      return -1;
    }

    @Override
    public void ended(TrialPhase phase, double began, double time) {
      Map<String, Object> members = new LinkedHashMap<>();
      members.put("phase", kind(phase));
      members.put("began", DecimalRounding.to(4, began));
      members.put("seconds", DecimalRounding.to(4, time - began));
      shown.add(members);
    }
  }
}
