package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.app.clock.Pace;
import org.selectiverenderer.app.head.HeadSession;
import org.selectiverenderer.app.head.TrackerTap;
import org.selectiverenderer.app.headset.HeadsetLink;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.tracker.HeadTracker;

/** Runs a scene from its beginning to its end. */
public final class SceneRunner {
  private SceneRunner() {}

  /**
   * Runs a scene in a window until the user, the settings or other code ends it. The window's
   * thread steps the world: in real time while the user navigates, by the frames of the path when
   * one is followed, so that its time line equals that of a simulation.
   *
   * @param stop by which other code ends the run
   * @throws IOException with a one-line message when the scene cannot be read
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static RunResult inWindow(RunSettings settings, RunListener listener, RunStop stop)
      throws IOException, InterruptedException {
    RunSettings fitted = WindowStage.fitted(settings, listener::printed);
    describe(fitted.display(), listener);
    FrameTarget target =
        new WindowFrames(
            host -> WindowStage.screen(fitted, Optional.empty(), host, listener::printed));
    return run(fitted, listener, stop, Pace.WATCHED, target);
  }

  /**
   * Runs a scene in a headset, with a mirror window; the headset's thread steps the world. Time
   * begins when the user sees the first frame, and is paused while nobody wears the headset.
   *
   * @param headset closed with the run
   * @param stop by which other code ends the run
   * @throws IOException with a one-line message when the scene cannot be read
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static RunResult inHeadset(
      RunSettings settings, HeadsetLink headset, RunListener listener, RunStop stop)
      throws IOException, InterruptedException {
    listener.printed(headset.describe());
    TrackerTap tap = new TrackerTap();
    HeadTracker tracker = headset.tracker(TrackerTap.hearing(tap, listener::problem));
    try (headset) {
      HeadSession head = HeadSession.with(tracker, tap, settings, listener::problem);
      listener.samples().ifPresent(head::tell);
      if (headset.tracksEyes()) {
        head.eyes(headset::gaze);
      }
      try (SceneRun run =
          new SceneRun(
              settings, listener, head, RunGuide.USER, Pace.WATCHED, stop, Optional.of(headset))) {
        FrameTarget target =
            new WindowFrames(
                host ->
                    WindowStage.screen(settings, Optional.of(headset), host, listener::printed));
        return run.end(target.show(run));
      }
    } finally {
      stop.ended();
    }
  }

  /**
   * Runs a scene without a window as fast as it can be drawn. With a path the frames are those of a
   * simulation; without one the viewer stays at the start, for the duration or for a single frame.
   *
   * @param stop by which other code ends the run early
   * @throws IOException with a one-line message when the scene cannot be read
   * @throws InterruptedException never
   */
  public static RunResult offscreen(RunSettings settings, RunListener listener, RunStop stop)
      throws IOException, InterruptedException {
    describe(settings.display(), listener);
    return run(settings, listener, stop, Pace.UNWATCHED, new OffscreenFrames(settings));
  }

  /**
   * Steps every frame of the path without drawing.
   *
   * @throws IOException with a one-line message when the scene cannot be read
   */
  public static RunResult simulated(RunSettings settings, RunListener listener)
      throws IOException, InterruptedException {
    return run(settings, listener, new RunStop(), Pace.UNWATCHED, new NoFrames());
  }

  private static RunResult run(
      RunSettings settings, RunListener listener, RunStop stop, Pace pace, FrameTarget target)
      throws IOException, InterruptedException {
    // From here on the tracker is open and the log's files are created.
    HeadSession head = HeadSession.open(settings, listener::problem);
    listener.samples().ifPresent(head::tell);
    try (SceneRun run = new SceneRun(settings, listener, head, RunGuide.USER, pace, stop)) {
      return run.end(target.show(run));
    } finally {
      stop.ended();
    }
  }

  /** Prints how the pictures of two eyes are shown. */
  private static void describe(DisplaySettings display, RunListener listener) {
    if (display.presentation().stereo()) {
      listener.printed(display.presentation().describe(display.width(), display.height()));
    }
  }
}
