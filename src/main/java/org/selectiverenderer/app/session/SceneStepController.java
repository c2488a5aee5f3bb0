package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.run.RunController;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.navigation.NavigationCommand;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.study.definition.MovementConstraint;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * Controls the run of a practice or an exposure: it starts at the step's viewpoint and lasts for
 * its time or until the experimenter continues. The picture fades in before the exposure's time
 * starts and fades out after it has ended.
 */
final class SceneStepController implements RunController {
  private final Session session;
  private final SessionStep step;
  private final String viewpoint;
  private final OptionalDouble exposure;
  private final double fade;
  private final ExperimenterControls controls;
  private final OperatorViewSettings stage;
  private final Consumer<Problem> problem;
  private @Nullable Walkthrough walk;
  private double begun;
  private double ending = Double.POSITIVE_INFINITY;
  private int frames;
  private boolean exposed;

  /**
   * @param exposure length of the exposure in seconds; empty for until the experimenter continues
   * @param stage the monitors and the view of the operator
   * @param problem receives a warning when the participant cannot be confined as the study asks
   */
  SceneStepController(
      Session session,
      SessionStep step,
      String viewpoint,
      OptionalDouble exposure,
      ExperimenterControls controls,
      OperatorViewSettings stage,
      Consumer<Problem> problem) {
    this.session = session;
    this.step = step;
    this.viewpoint = viewpoint;
    this.exposure = exposure;
    this.controls = controls;
    this.stage = stage;
    this.problem = problem;
    fade = session.material().study().fade();
  }

  @Override
  public void opened(Walkthrough opened) {
    walk = opened;
    controls.takeGoOn(); // Discards a request from before the step began.
    opened.world().views().viewpoints().stream()
        .filter(node -> viewpoint.equals(node.name()))
        .findFirst()
        .ifPresent(opened.world().views()::goTo);
  }

  @Override
  public ViewerMotion motion(ViewerMotion users) {
    ParticipantMotion motion = new ParticipantMotion(session, problem);
    Walkthrough scene = walk;
    return scene != null && step instanceof SessionStep.Exposure exposed
        ? motion.within(scene, exposed.area(), users)
        : motion.free(users);
  }

  @Override
  public void heard(NavigationCommand command) {
    if (command == NavigationCommand.RESET_HEADING) {
      session.journal().tell("heading-reset", Map.of("step", step.id()));
    }
  }

  @Override
  public boolean walks() {
    boolean turns =
        step instanceof SessionStep.Exposure exposure
            && session.material().study().stay(exposure.area()) == MovementConstraint.TURN;
    return !turns && !session.options().unattended();
  }

  @Override
  public boolean takeHeadingReset() {
    return controls.takeResetHeading();
  }

  @Override
  public void operatorKey(KeyboardKey key, boolean participants) {
    // Where the operator has the pointer, keys pressed by the participant are ignored.
    if (participants && !stage.pointerKept()) {
      return;
    }
    switch (key) {
      case F8 -> controls.pause(!controls.paused());
      case F9 -> controls.goOn();
      default -> {
        // Other keys have no meaning for the operator.
      }
    }
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
  public boolean over(double seconds) {
    // The first frame is slow because the scene is uploaded to the GPU; as a part of the fade it
    // would make the picture appear at once.
    if (++frames <= 2) {
      begun = seconds;
      ending = begun + fade + exposure.orElse(Double.POSITIVE_INFINITY);
    }
    if (!exposed && frames > 1 && seconds >= begun + fade) {
      exposed = true;
      session.journal().signal("exposure-began", step.id(), text -> text);
      session
          .journal()
          .tell("shown", Map.of("step", step.id(), "t", DecimalRounding.to(3, seconds)));
    }
    if (exposure.isEmpty() && controls.takeGoOn()) {
      ending = seconds;
    }
    controls.status(left(seconds));
    return controls.aborted() || seconds >= ending + fade;
  }

  @Override
  public double darkness(double seconds) {
    if (controls.paused()) {
      return 1;
    }
    double coming = frames <= 1 ? 1 : fade > 0 ? 1 - (seconds - begun) / fade : 0;
    double going = seconds < ending ? 0 : fade > 0 ? (seconds - ending) / fade : 1;
    return Math.max(coming, going);
  }

  @Override
  public boolean closing() {
    return !controls.askAbort();
  }

  /** Returns the elapsed seconds of the exposure at a time of the run. */
  double exposed(double seconds) {
    return Math.max(0, Math.min(seconds, ending) - begun - fade);
  }

  private String left(double seconds) {
    String what =
        exposure.isPresent()
            ? String.format(
                Locale.ROOT, "%.0f s left", Math.ceil(exposure.getAsDouble() - exposed(seconds)))
            : String.format(Locale.ROOT, "%.0f s so far; press Go on to end it", seconds);
    return step.id() + ": " + (controls.paused() ? "PAUSED, " : "") + what;
  }

  @Override
  public List<String> operatorLines(double seconds) {
    List<String> lines = new ArrayList<>();
    lines.add(
        "participant "
            + session.folder().participant()
            + session
                .group()
                .filter(known -> !stage.blind())
                .map(group -> ", " + group.name())
                .orElse(""));
    lines.add(left(seconds));
    return lines;
  }
}
