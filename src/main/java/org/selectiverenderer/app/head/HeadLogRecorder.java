package org.selectiverenderer.app.head;

import java.io.IOException;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.apparatus.FieldOfView;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.study.headlog.EyeSample;
import org.selectiverenderer.study.headlog.HeadLogFiles;
import org.selectiverenderer.study.headlog.HeadLogMetadata;
import org.selectiverenderer.study.headlog.HeadLogWriter;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.walkthrough.Walkthrough;

/** Samples the viewer's pose and gaze once per frame, for a head log, a listener, or both. */
final class HeadLogRecorder implements AutoCloseable {
  /**
   * The rotation in radians below which the head counts as idle between two frames; {@code
   * STILL_WAY} is the distance in scene units.
   */
  private static final double STILL_ANGLE = Math.toRadians(0.05);

  private static final double STILL_WAY = 1e-3;

  private final Walkthrough walk;
  private final @Nullable HeadLogWriter writer;
  private final @Nullable HeadSampleListener listener;
  private final GazeTargetFinder gaze;
  private final boolean eyes;
  private final PoseSample angles = new PoseSample();
  private final Vector3d lastPosition = new Vector3d(Double.NaN);
  private final Quaterniond lastOrientation = new Quaterniond();
  private @Nullable FrameTimestamp last;

  private HeadLogRecorder(
      Walkthrough walk,
      @Nullable HeadLogWriter writer,
      @Nullable HeadSampleListener listener,
      double coneDegrees,
      boolean eyes) {
    this.walk = walk;
    this.eyes = eyes;
    this.writer = writer;
    this.listener = listener;
    gaze = new GazeTargetFinder(walk.world(), coneDegrees);
  }

  /**
   * Starts recording.
   *
   * @param files the files of the head log, closed with the recorder; null for no log
   * @param listener receives the samples, too; null for none
   * @param coneDegrees width of the gaze cone in which objects are listed
   * @param eyes whether an eye tracker is present
   * @throws IOException if the log cannot be written
   */
  static HeadLogRecorder open(
      @Nullable HeadLogFiles files,
      @Nullable HeadSampleListener listener,
      double coneDegrees,
      boolean eyes,
      RunSettings settings,
      Walkthrough walk,
      Consumer<Problem> problem)
      throws IOException {
    HeadLogMetadata description = description(settings, coneDegrees, eyes, walk);
    if (listener != null) {
      listener.scene(description);
    }
    HeadLogWriter writer = files == null ? null : HeadLogWriter.open(files, description, problem);
    return new HeadLogRecorder(walk, writer, listener, coneDegrees, eyes);
  }

  private static HeadLogMetadata description(
      RunSettings settings, double coneDegrees, boolean eyes, Walkthrough walk) {
    int width = settings.display().width();
    int height = settings.display().height();
    DisplayConfiguration shown = settings.display().presentation();
    FieldOfView field = shown.seen(walk.world().viewer().fieldOfView(), width, height);
    SelectiveController.Settings rendering = settings.scene().rendering();
    return new HeadLogMetadata(
        OffsetDateTime.now().truncatedTo(ChronoUnit.MILLIS).toString(),
        String.valueOf(settings.scene().file().getFileName()),
        rendering.condition().name().toLowerCase(Locale.ROOT).replace('_', '-'),
        rendering.seed(),
        shown.stereo() ? shown.describe(width, height) : "window of %dx%d".formatted(width, height),
        settings.tracker().spec().toString(),
        field.x(),
        field.y(),
        walk.world().scene().unitLength(),
        coneDegrees,
        eyes,
        SceneMapBuilder.of(walk.world().instances()));
  }

  /**
   * Samples a frame. It must be called before the next step, so that the object in the middle of
   * the view is still that of the frame.
   *
   * @param visible whether the participant saw it
   * @param looked direction of the eyes in head coordinates; empty where it is not known
   */
  void frame(FrameTimestamp frame, boolean visible, Optional<Vector3d> looked) {
    Viewer viewer = walk.world().viewer();
    Vector3dc at = viewer.position();
    Quaterniondc turn = viewer.orientation();
    angles.turn(turn.x(), turn.y(), turn.z(), turn.w());
    boolean moved =
        at.distance(lastPosition) >= STILL_WAY
            || turn.difference(lastOrientation, new Quaterniond()).angle() >= STILL_ANGLE;
    GazeTargetFinder.Found found = gaze.find();
    HeadSample sample =
        new HeadSample(
            frame.time(),
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
            last == null ? 0 : frame.millisecondsSince(last),
            new HeadSample.Moment(visible, frame.wall(), frame.nanos() * 1e-9),
            eyes ? looked.map(gaze::eyes).orElse(EyeSample.LOST) : null);
    if (writer != null) {
      writer.add(sample);
    }
    if (listener != null) {
      listener.sampled(sample, frame.nanos());
    }
    lastPosition.set(at);
    lastOrientation.set(turn);
    last = frame;
  }

  @Override
  public void close() throws IOException {
    if (writer != null) {
      writer.close();
    }
  }
}
