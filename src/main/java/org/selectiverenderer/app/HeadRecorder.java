package org.selectiverenderer.app;

import java.io.IOException;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.experiment.headlog.Gaze;
import org.selectiverenderer.experiment.headlog.HeadLogDescription;
import org.selectiverenderer.experiment.headlog.HeadLogWriter;
import org.selectiverenderer.experiment.headlog.HeadSample;
import org.selectiverenderer.experiment.headlog.SceneSurvey;
import org.selectiverenderer.hmd.FieldOfView;
import org.selectiverenderer.runtime.navigation.Viewer;
import org.selectiverenderer.tracker.PoseSample;

/** Samples the viewer of a walk for its head log, once per frame. */
final class HeadRecorder implements AutoCloseable {
  /** Radians and scene units below which the head counts as idle. */
  private static final double STILL_ANGLE = Math.toRadians(0.05);

  private static final double STILL_WAY = 1e-3;

  private final Walkthrough walk;
  private final HeadLogWriter writer;
  private final Gaze gaze;
  private final PoseSample angles = new PoseSample();
  private final Vector3d lastPosition = new Vector3d(Double.NaN);
  private final Quaterniond lastOrientation = new Quaterniond();
  private long lastFrame;

  private HeadRecorder(Walkthrough walk, HeadLogWriter writer, double coneDegrees) {
    this.walk = walk;
    this.writer = writer;
    gaze = new Gaze(walk.world(), coneDegrees);
  }

  /**
   * Begins the log that the settings name.
   *
   * @throws IOException if it cannot be written
   */
  static HeadRecorder open(RunSettings settings, Walkthrough walk, RunListener listener)
      throws IOException {
    HeadSettings head = settings.head();
    return new HeadRecorder(
        walk,
        HeadLogWriter.open(
            head.log().orElseThrow(), description(settings, walk), listener::problem),
        head.coneDegrees());
  }

  private static HeadLogDescription description(RunSettings settings, Walkthrough walk) {
    int width = settings.width();
    int height = settings.height();
    boolean stereo = settings.presentation().stereo();
    FieldOfView field =
        stereo
            ? settings.presentation().geometry().profile().fieldOfView()
            : window(walk.world().viewer(), width, height);
    SelectiveController.Settings rendering = settings.rendering();
    return new HeadLogDescription(
        OffsetDateTime.now().truncatedTo(ChronoUnit.MILLIS).toString(),
        String.valueOf(settings.scene().getFileName()),
        rendering.condition().name().toLowerCase(Locale.ROOT).replace('_', '-'),
        rendering.seed(),
        stereo
            ? settings.presentation().describe(width, height)
            : "window of %dx%d".formatted(width, height),
        settings.head().tracker().toString(),
        field.x(),
        field.y(),
        walk.world().scene().unitLength(),
        settings.head().coneDegrees(),
        SceneSurvey.of(walk.world().instances()));
  }

  private static FieldOfView window(Viewer viewer, int width, int height) {
    double half = Math.tan(viewer.fieldOfView() / 2) / Math.min(width, height);
    return new FieldOfView(half * width, half * height);
  }

  /** A frame was stepped. */
  void frame(double time) {
    long now = System.nanoTime();
    Viewer viewer = walk.world().viewer();
    Vector3dc at = viewer.position();
    Quaterniondc turn = viewer.orientation();
    angles.turn(turn.x(), turn.y(), turn.z(), turn.w());
    boolean moved =
        at.distance(lastPosition) >= STILL_WAY
            || turn.difference(lastOrientation, new Quaterniond()).angle() >= STILL_ANGLE;
    Gaze.Found found = gaze.find();
    writer.add(
        new HeadSample(
            time,
            at.x(),
            at.y(),
            at.z(),
            angles.yaw(),
            angles.pitch(),
            angles.roll(),
            moved,
            found.object(),
            found.distance(),
            found.version(),
            found.cone(),
            walk.activeSchemas(),
            lastFrame == 0 ? 0 : (now - lastFrame) * 1e-6));
    lastPosition.set(at);
    lastOrientation.set(turn);
    lastFrame = now;
  }

  @Override
  public void close() throws IOException {
    writer.close();
  }
}
