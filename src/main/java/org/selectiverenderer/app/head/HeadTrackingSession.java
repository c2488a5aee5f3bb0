package org.selectiverenderer.app.head;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.settings.HeadLogSettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.hmd.HeadTrackedCollision;
import org.selectiverenderer.hmd.HeadTrackedMotion;
import org.selectiverenderer.hmd.HeadTrackingOptions;
import org.selectiverenderer.study.headlog.HeadLogFiles;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.LatencyHistogram;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.factory.TrackerFactory;
import org.selectiverenderer.tracker.replay.FrameSteppedReplay;
import org.selectiverenderer.tracker.replay.ReplayLog;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * The head tracking of a run: the tracker, the head log, and the latency from a tracker sample to
 * its picture. It is opened before the scene, so that a tracker that cannot be used ends the run at
 * once. It is confined to the thread that steps the world.
 */
public final class HeadTrackingSession implements AutoCloseable {
  private final RunSettings settings;
  private final Consumer<Problem> problem;
  private final HeadTracker tracker;
  private final @Nullable ReplayLog replay;
  private final @Nullable HeadLogFiles files;
  private final TrackerRecorder tap;
  private final LatencyHistogram latency = new LatencyHistogram();
  private final TrackerSilenceMeter silence = new TrackerSilenceMeter();
  private final PoseSample newest = new PoseSample();
  private @Nullable HeadSampleListener listener;
  private @Nullable HeadTrackedMotion motion;
  private @Nullable HeadLogRecorder recorder;
  private @Nullable FrameTimestamp unlogged;
  private @Nullable Supplier<Optional<Vector3d>> eyes;
  private Optional<Vector3d> looked = Optional.empty();

  private HeadTrackingSession(
      RunSettings settings,
      Consumer<Problem> problem,
      HeadTracker tracker,
      @Nullable ReplayLog replay,
      @Nullable HeadLogFiles files,
      TrackerRecorder tap) {
    this.settings = settings;
    this.tap = tap;
    this.problem = problem;
    this.tracker = tracker;
    this.replay = replay;
    this.files = files;
  }

  /**
   * Creates the log's files, then opens the tracker.
   *
   * @param problem receives the problems of the tracker and the log
   * @throws TrackerException when it cannot be used
   * @throws IOException when the log cannot be written or is there already
   */
  public static HeadTrackingSession open(RunSettings settings, Consumer<Problem> problem)
      throws IOException {
    HeadLogFiles files = claimed(settings);
    try {
      return open(settings, problem, files);
    } catch (IOException | RuntimeException e) {
      if (files != null) {
        files.close();
      }
      throw e;
    }
  }

  private static HeadTrackingSession open(
      RunSettings settings, Consumer<Problem> problem, @Nullable HeadLogFiles files)
      throws IOException {
    TrackerSettings tracking = settings.tracker();
    if (!(tracking.spec() instanceof TrackerSpec.Replay spec)) {
      TrackerRecorder tap = new TrackerRecorder();
      HeadTracker live =
          TrackerFactory.open(
              tracking.spec(), tracking.options(), TrackerRecorder.hearing(tap, problem));
      return new HeadTrackingSession(settings, problem, live, null, files, tap);
    }
    // A log is replayed by the frames' clock, so that each run of it shows the same.
    ReplayLog log =
        ReplayLog.read(spec.file(), new ProblemCollector(problem))
            .orElseThrow(
                () -> new TrackerException("the log " + spec.file() + " cannot be replayed"));
    if (tracking.placed() && !log.placed()) {
      throw new TrackerException(
          spec.file()
              + ": has no columns right, up and back, which --tracker-position on needs; leave it"
              + " out");
    }
    HeadTracker stepped = new FrameSteppedReplay(spec, log, tracking.options());
    return new HeadTrackingSession(settings, problem, stepped, log, files, new TrackerRecorder());
  }

  /**
   * Creates the head tracking of a run from a live tracker that is open already.
   *
   * @param tap receives the tracker's samples
   * @throws IOException when the log cannot be written or is there already
   */
  public static HeadTrackingSession with(
      HeadTracker tracker, TrackerRecorder tap, RunSettings settings, Consumer<Problem> problem)
      throws IOException {
    return new HeadTrackingSession(settings, problem, tracker, null, claimed(settings), tap);
  }

  private static @Nullable HeadLogFiles claimed(RunSettings settings) throws IOException {
    HeadLogSettings log = settings.log().orElse(null);
    return log == null ? null : HeadLogFiles.claim(log.file(), log.replace());
  }

  /** Sets a listener for the samples of every frame; to be called before {@link #begin}. */
  public void tell(HeadSampleListener hears) {
    listener = hears;
  }

  /**
   * Sets the eye tracker; to be called before {@link #begin}.
   *
   * @param direction the direction of gaze in the frame that is due, a unit vector in head
   *     coordinates; empty while it is not known
   */
  public void eyes(Supplier<Optional<Vector3d>> direction) {
    eyes = direction;
  }

  /** Returns the length of a replayed log in seconds; empty for a live tracker. */
  public OptionalDouble replayed() {
    return replay == null ? OptionalDouble.empty() : OptionalDouble.of(replay.duration());
  }

  /**
   * Begins with a scene.
   *
   * @param walking the viewer's motion without the tracker
   * @param body follows the head where the tracker reports its position; null for none
   * @return the viewer's motion including the tracker
   * @throws IOException if the log cannot be written
   */
  public ViewerMotion begin(
      Walkthrough walk, ViewerMotion walking, @Nullable HeadTrackedCollision body)
      throws IOException {
    Supplier<Optional<Vector3d>> gaze = eyes;
    if (gaze != null) {
      walk.budget().ifPresent(budget -> budget.gaze(gaze));
    }
    if (files != null || listener != null) {
      double cone = settings.log().map(HeadLogSettings::coneDegrees).orElse(HeadLogSettings.CONE);
      recorder = HeadLogRecorder.open(files, listener, cone, eyes != null, settings, walk, problem);
    }
    if (files != null && settings.tracker().tracked() && replay == null) {
      tap.open(
          settings.log().orElseThrow(),
          settings.tracker().spec().toString(),
          tracker.placed(),
          problem);
    }
    if (!settings.tracker().tracked()) {
      return walking;
    }
    HeadTrackedMotion tracked =
        new HeadTrackedMotion(
            walk.world(), tracker, walking, settings.tracker().whenLost(), place(), body);
    motion = tracked;
    ReplayLog played = replay;
    if (played == null || !(tracker instanceof FrameSteppedReplay stepped)) {
      return tracked;
    }
    return (viewer, time, dt) -> {
      stepped.advanceTo(played.time(0) + time);
      tracked.move(viewer, time, dt);
    };
  }

  /** Returns how the position of the head is used. */
  private HeadTrackingOptions place() {
    return settings
        .display()
        .presentation()
        .headset()
        .map(shown -> new HeadTrackingOptions(true, shown.layout()::floor, shown.size()))
        .orElse(
            settings.tracker().placed() ? HeadTrackingOptions.SEATED : HeadTrackingOptions.TURNED);
  }

  /** Returns a line of text about the state of the tracker, if it has one. */
  public Optional<String> described() {
    return tracker.described();
  }

  /** Reports that a frame was stepped; it is logged by {@link #log}. */
  public void stepped(FrameTimestamp frame) {
    unlogged = frame;
    Supplier<Optional<Vector3d>> told = eyes;
    looked = told == null ? Optional.empty() : told.get();
    if (motion != null) {
      // Of several frames that are stepped at once after a slow picture only one is fresh: the
      // scene's time between them is not a silence.
      double now = replay != null ? frame.time() : (frame.nanos() - frame.paused()) * 1e-9;
      silence.frame(now, heard(frame));
    }
  }

  /**
   * Returns whether a record has come since the last frame. The tracker itself is asked, because a
   * run may leave out the motion that reads it: a simulated participant turns the view.
   */
  private boolean heard(FrameTimestamp frame) {
    if (replay != null && tracker instanceof FrameSteppedReplay stepped) {
      stepped.advanceTo(replay.time(0) + frame.time());
    }
    long before = newest.number();
    return tracker.read(newest) && newest.number() != before;
  }

  /** Returns the longest time that the run went on without a tracker sample, in seconds. */
  public double longestSilence() {
    return silence.longest();
  }

  /**
   * Logs the frame last stepped, unless it has been logged. This is done after the frame is
   * submitted, because the ray cast for the gaze would delay it, or before the next frame is
   * stepped.
   *
   * @param visible whether the participant saw it
   */
  public void log(boolean visible) {
    FrameTimestamp frame = unlogged;
    if (recorder != null && frame != null) {
      recorder.frame(frame, visible, looked);
    }
    unlogged = null;
  }

  /** Reports that the frame was submitted to the display. */
  public void submitted() {
    HeadTrackedMotion tracked = motion;
    if (tracked != null && tracked.fresh() && replay == null) {
      latency.record(System.nanoTime() - tracked.sample().arrival());
    }
  }

  /** Returns whether the tracker turns the view. */
  public boolean steering() {
    return motion != null && motion.steering();
  }

  /** Makes the present direction of the head the new straight ahead. */
  public void resetHeading() {
    tracker.resetHeading();
  }

  public TrackerHealth health() {
    return tracker.health();
  }

  /** Returns the last pose of the tracker; its number is 0 before the first. */
  public PoseSample pose() {
    HeadTrackedMotion tracked = motion;
    return tracked == null ? new PoseSample() : tracked.sample();
  }

  public LatencyHistogram latency() {
    return latency;
  }

  @Override
  public void close() throws IOException {
    try (tap) {
      tracker.close();
      closeLog();
    }
  }

  private void closeLog() throws IOException {
    if (recorder != null) {
      recorder.close();
    } else if (files != null) {
      files.close();
    }
  }
}
