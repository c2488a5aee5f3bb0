package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.app.clock.TimingMode;
import org.selectiverenderer.app.head.HeadTrackingSession;
import org.selectiverenderer.app.head.TrackerRecorder;
import org.selectiverenderer.app.headset.HeadsetConnection;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.display.WorldController;
import org.selectiverenderer.render.display.WorldDisplay;
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
  public static RunResult inWindow(RunSettings settings, RunListener listener, RunCancellation stop)
      throws IOException, InterruptedException {
    RunSettings fitted = RunWindowFactory.fitted(settings, listener::printed);
    describe(fitted.display(), listener);
    FrameTarget target =
        new WindowFrameTarget(
            host -> RunWindowFactory.screen(fitted, Optional.empty(), host, listener::printed));
    return run(fitted, listener, stop, TimingMode.WATCHED, target);
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
      RunSettings settings, HeadsetConnection headset, RunListener listener, RunCancellation stop)
      throws IOException, InterruptedException {
    listener.printed(headset.describe());
    TrackerRecorder tap = new TrackerRecorder();
    HeadTracker tracker = headset.tracker(TrackerRecorder.hearing(tap, listener::problem));
    try (headset) {
      HeadTrackingSession head =
          HeadTrackingSession.with(tracker, tap, settings, listener::problem);
      listener.samples().ifPresent(head::tell);
      if (headset.tracksEyes()) {
        head.eyes(headset::gaze);
      }
      try (SceneRun run =
          new SceneRun(
              settings,
              listener,
              head,
              RunController.USER,
              TimingMode.WATCHED,
              stop,
              Optional.of(headset))) {
        FrameTarget target =
            new WindowFrameTarget(
                host ->
                    RunWindowFactory.screen(
                        settings, Optional.of(headset), host, listener::printed));
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
  public static RunResult offscreen(
      RunSettings settings, RunListener listener, RunCancellation stop)
      throws IOException, InterruptedException {
    describe(settings.display(), listener);
    return run(settings, listener, stop, TimingMode.UNWATCHED, new OffscreenFrameTarget(settings));
  }

  /**
   * Steps every frame of the path without drawing.
   *
   * @throws IOException with a one-line message when the scene cannot be read
   */
  public static RunResult simulated(RunSettings settings, RunListener listener)
      throws IOException, InterruptedException {
    return run(
        settings,
        listener,
        new RunCancellation(),
        TimingMode.UNWATCHED,
        new NullFrameTarget(settings.display()));
  }

  private static RunResult run(
      RunSettings settings,
      RunListener listener,
      RunCancellation stop,
      TimingMode pace,
      FrameTarget target)
      throws IOException, InterruptedException {
    // From here on the tracker is open and the log's files are created.
    HeadTrackingSession head = HeadTrackingSession.open(settings, listener::problem);
    listener.samples().ifPresent(head::tell);
    try (SceneRun run = new SceneRun(settings, listener, head, RunController.USER, pace, stop)) {
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

  /** A frame target that steps the run without drawing, and needs no display. */
  private static final class NullFrameTarget implements FrameTarget {
    private final DisplaySettings size;

    /**
     * @param size of the picture that would be drawn
     */
    NullFrameTarget(DisplaySettings size) {
      this.size = size;
    }

    @Override
    public LastPictures show(SceneRun run) throws IOException {
      run.awaitScene();
      do {
        run.step().ifPresent(world -> world.seenIn(size.width(), size.height(), Optional.empty()));
        run.submitted();
      } while (!run.finished());
      return LastPictures.NONE;
    }
  }

  /**
   * A frame target that shows frames in windows or in a headset. These open while the scene is
   * being loaded, and their thread steps the run.
   */
  private static final class WindowFrameTarget implements FrameTarget {
    private final Function<WorldController, WorldDisplay> screens;

    /**
     * @param screens creates the screen that shows the world of a host
     */
    WindowFrameTarget(Function<WorldController, WorldDisplay> screens) {
      this.screens = screens;
    }

    @Override
    public LastPictures show(SceneRun run) throws InterruptedException {
      WorldDisplay window = screens.apply(run);
      window.run();
      return new LastPictures(
          window.info().orElse(new GlInfo("", "", "")),
          window.lastPicture(),
          window.lastOperatorPicture());
    }
  }
}
