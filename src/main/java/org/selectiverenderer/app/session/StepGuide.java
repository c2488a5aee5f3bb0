package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.joml.Quaterniond;
import org.selectiverenderer.app.run.RunGuide;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.base.decimal.Rounded;
import org.selectiverenderer.experiment.session.OperatorControls;
import org.selectiverenderer.experiment.session.Session;
import org.selectiverenderer.experiment.session.SessionStep;
import org.selectiverenderer.runtime.viewer.ViewerMotion;

/**
 * Leads practice or an exposure: from its viewpoint, for its time or until the experimenter goes
 * on. The picture comes before the exposure's clock starts and goes after it has ended.
 */
final class StepGuide implements RunGuide {
  /** Radians per second at which a simulated participant turns: once round in 20 s. */
  private static final double TURN = 2 * Math.PI / 20;

  private final Session session;
  private final SessionStep step;
  private final String viewpoint;
  private final OptionalDouble exposure;
  private final double fade;
  private final OperatorControls controls;
  private double begun;
  private double ending = Double.POSITIVE_INFINITY;
  private int frames;
  private boolean exposed;

  /**
   * @param exposure seconds; empty until the experimenter goes on
   */
  StepGuide(
      Session session,
      SessionStep step,
      String viewpoint,
      OptionalDouble exposure,
      OperatorControls controls) {
    this.session = session;
    this.step = step;
    this.viewpoint = viewpoint;
    this.exposure = exposure;
    this.controls = controls;
    fade = session.material().study().fade();
  }

  @Override
  public void opened(Walkthrough walk) {
    controls.takeGoOn(); // Asked for before there was anything to go on from.
    walk.world().viewpoints().stream()
        .filter(node -> viewpoint.equals(node.name()))
        .findFirst()
        .ifPresent(walk.world()::goTo);
  }

  @Override
  public ViewerMotion motion(ViewerMotion users) {
    if (!session.options().unattended()) {
      return users;
    }
    return (viewer, time, dt) ->
        viewer.turnTo(new Quaterniond().rotationY(TURN * dt).mul(viewer.orientation()));
  }

  @Override
  public boolean paused() {
    return controls.paused();
  }

  @Override
  public boolean over(double seconds) {
    // The first frame takes long, as all goes to the graphics card then: were it part of the fade,
    // the picture would come at once.
    if (++frames <= 2) {
      begun = seconds;
      ending = begun + fade + exposure.orElse(Double.POSITIVE_INFINITY);
    }
    if (!exposed && frames > 1 && seconds >= begun + fade) {
      exposed = true;
      session.journal().tell("shown", Map.of("step", step.id(), "t", Rounded.to(3, seconds)));
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

  /** Seconds of the exposure that are over at a time of the run. */
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
        "participant %s, %s"
            .formatted(
                session.folder().participant(),
                session.condition().map(condition -> condition.spelling()).orElse("")));
    lines.add(left(seconds));
    return lines;
  }
}
