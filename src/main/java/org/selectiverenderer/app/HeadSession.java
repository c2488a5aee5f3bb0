package org.selectiverenderer.app;

import java.io.IOException;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.experiment.headlog.HeadLogFiles;
import org.selectiverenderer.hmd.TrackedMotion;
import org.selectiverenderer.runtime.navigation.ViewerMotion;
import org.selectiverenderer.tracker.HeadTracker;
import org.selectiverenderer.tracker.LatencyMeter;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.TrackerListener;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.Trackers;
import org.selectiverenderer.tracker.replay.ReplayLog;
import org.selectiverenderer.tracker.replay.SteppedReplay;
import org.selectiverenderer.x3d.Problem;
import org.selectiverenderer.x3d.Problems;

/**
 * The head during a run: its tracker, its log, and how long a record takes to become a picture.
 * Opened before the scene, so that a tracker that cannot be used ends the run at once. Belongs to
 * the thread that steps the world.
 */
final class HeadSession implements AutoCloseable {
  private final RunSettings settings;
  private final RunListener listener;
  private final HeadTracker tracker;
  private final @Nullable ReplayLog log;
  private final @Nullable HeadLogFiles files;
  private final LatencyMeter latency = new LatencyMeter();
  private @Nullable TrackedMotion motion;
  private @Nullable HeadRecorder recorder;

  private HeadSession(
      RunSettings settings,
      RunListener listener,
      HeadTracker tracker,
      @Nullable ReplayLog log,
      @Nullable HeadLogFiles files) {
    this.settings = settings;
    this.listener = listener;
    this.tracker = tracker;
    this.log = log;
    this.files = files;
  }

  /**
   * Takes the log's files, then opens the tracker.
   *
   * @throws TrackerException when it cannot be used
   * @throws IOException when the log cannot be written or is there already
   */
  static HeadSession open(RunSettings settings, RunListener listener) throws IOException {
    HeadLogFiles files = claimed(settings.head());
    try {
      return open(settings, listener, files);
    } catch (IOException | RuntimeException e) {
      if (files != null) {
        files.close();
      }
      throw e;
    }
  }

  private static HeadSession open(
      RunSettings settings, RunListener listener, @Nullable HeadLogFiles files) throws IOException {
    TrackerListener heard =
        new TrackerListener() {
          @Override
          public void problem(Problem problem) {
            listener.problem(problem);
          }
        };
    HeadSettings head = settings.head();
    if (!(head.tracker() instanceof TrackerSpec.Replay replay)) {
      HeadTracker live = Trackers.open(head.tracker(), head.options(), heard);
      return new HeadSession(settings, listener, live, null, files);
    }
    // A log is replayed by the frames' clock, so that each run of it shows the same.
    ReplayLog log =
        ReplayLog.read(replay.file(), new Problems(heard::problem))
            .orElseThrow(() -> new TrackerException("the log " + replay.file() + " has faults"));
    HeadTracker stepped = new SteppedReplay(replay, log, head.options());
    return new HeadSession(settings, listener, stepped, log, files);
  }

  /**
   * With a live tracker that is open already.
   *
   * @throws IOException when the log cannot be written or is there already
   */
  static HeadSession with(HeadTracker tracker, RunSettings settings, RunListener listener)
      throws IOException {
    return new HeadSession(settings, listener, tracker, null, claimed(settings.head()));
  }

  private static @Nullable HeadLogFiles claimed(HeadSettings head) throws IOException {
    return head.log().isEmpty() ? null : HeadLogFiles.claim(head.log().get(), head.replaceLog());
  }

  /** How many seconds a replay lasts; empty for a live tracker. */
  OptionalDouble replayed() {
    ReplayLog replay = log;
    return replay == null ? OptionalDouble.empty() : OptionalDouble.of(replay.duration());
  }

  /**
   * Begins with a scene.
   *
   * @param walking what moves the viewer besides the tracker
   * @return what moves the viewer
   * @throws IOException if the log cannot be written
   */
  ViewerMotion begin(Walkthrough walk, ViewerMotion walking) throws IOException {
    if (files != null) {
      recorder = HeadRecorder.open(files, settings, walk, listener);
    }
    if (!settings.head().tracked()) {
      return walking;
    }
    TrackedMotion tracked =
        new TrackedMotion(walk.world(), tracker, walking, settings.head().whenLost());
    motion = tracked;
    ReplayLog played = log;
    if (played == null || !(tracker instanceof SteppedReplay replay)) {
      return tracked;
    }
    return (viewer, time, dt) -> {
      replay.advanceTo(played.time(0) + time);
      tracked.move(viewer, time, dt);
    };
  }

  /**
   * Logs the frame of a time. For live frames after they are submitted, which looking for what is
   * in the middle of the view would delay.
   */
  void log(double time) {
    if (recorder != null) {
      recorder.frame(time);
    }
  }

  /** The frame was handed to the display. */
  void submitted() {
    TrackedMotion tracked = motion;
    if (tracked != null && tracked.fresh() && log == null) {
      latency.record(System.nanoTime() - tracked.sample().arrival());
    }
  }

  /** Whether the tracker turns the view. */
  boolean steering() {
    return motion != null && motion.steering();
  }

  /** Where the head looks now is straight ahead from now on. */
  void resetHeading() {
    tracker.resetHeading();
  }

  TrackerHealth health() {
    return tracker.health();
  }

  /** The head's pose as the tracker told it last; number 0 before the first. */
  PoseSample pose() {
    TrackedMotion tracked = motion;
    return tracked == null ? new PoseSample() : tracked.sample();
  }

  LatencyMeter latency() {
    return latency;
  }

  @Override
  public void close() throws IOException {
    tracker.close();
    if (recorder != null) {
      recorder.close();
    } else if (files != null) {
      files.close();
    }
  }
}
