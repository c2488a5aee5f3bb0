package org.selectiverenderer.app;

import java.io.IOException;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
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
  private final LatencyMeter latency = new LatencyMeter();
  private @Nullable TrackedMotion motion;
  private @Nullable HeadRecorder recorder;

  private HeadSession(
      RunSettings settings, RunListener listener, HeadTracker tracker, @Nullable ReplayLog log) {
    this.settings = settings;
    this.listener = listener;
    this.tracker = tracker;
    this.log = log;
  }

  /**
   * Opens the tracker.
   *
   * @throws TrackerException when it cannot be used
   */
  static HeadSession open(RunSettings settings, RunListener listener) throws IOException {
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
      return new HeadSession(settings, listener, live, null);
    }
    // A log is replayed by the frames' clock, so that each run of it shows the same.
    ReplayLog log =
        ReplayLog.read(replay.file(), new Problems(heard::problem))
            .orElseThrow(() -> new TrackerException("the log " + replay.file() + " has faults"));
    HeadTracker stepped = new SteppedReplay(replay, log, head.options());
    return new HeadSession(settings, listener, stepped, log);
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
    if (settings.head().log().isPresent()) {
      recorder = HeadRecorder.open(settings, walk, listener);
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
    }
  }
}
