package org.selectiverenderer.app;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.runtime.navigation.PathMotion;
import org.selectiverenderer.runtime.navigation.ViewerMotion;
import org.selectiverenderer.runtime.render.AntiAliasing;
import org.selectiverenderer.runtime.render.Drawn;
import org.selectiverenderer.runtime.render.OffscreenView;

/**
 * Runs a scene without a window, as fast as it can be drawn. With a path its frames are those of a
 * simulation; without one the viewer stays at the start, for the duration or for a single frame.
 * The calling thread steps and draws.
 */
public final class OffscreenRun {
  private final RunSettings settings;

  public OffscreenRun(RunSettings settings) {
    this.settings = settings;
  }

  /**
   * @throws IOException with a one-line message when the scene cannot be read
   */
  public RunResult run(RunListener listener) throws IOException {
    FigureKeeper keeper = new FigureKeeper();
    try (HeadSession head = HeadSession.open(settings, listener);
        SceneOpening opening = new SceneOpening(settings, listener);
        // The context comes up while the scene is being read.
        OffscreenView view =
            OffscreenView.open(
                settings.width(), settings.height(), samples(), settings.presentation().layout());
        Walkthrough walk = opening.await()) {
      keeper.loaded();
      walk(walk, view, keeper, head);
      walk.end();
      return new RunResult(
          keeper.figures(view.info(), head.latency()),
          walk.problems().any(),
          Optional.of(view.screenshot()),
          Optional.empty());
    }
  }

  /** A single picture is worth smooth edges; many are not where they take too long. */
  private int samples() {
    boolean still =
        settings.path().isEmpty() && settings.duration().isEmpty() && !settings.head().tracked();
    return settings
        .samples()
        .orElseGet(() -> still ? AntiAliasing.SMOOTH : AntiAliasing.forMotion());
  }

  private void walk(Walkthrough walk, OffscreenView view, FigureKeeper keeper, HeadSession head)
      throws IOException {
    FrameSchedule schedule = schedule(head);
    ViewerMotion motion =
        head.begin(
            walk,
            settings
                .path()
                .map(path -> (ViewerMotion) new PathMotion(path, 0))
                .orElse(Walkthrough.STANDING));
    for (long frame = 0; schedule.has(frame); frame++) {
      if (settings.head().tracked()) {
        view.awaitReady(); // The pose is read in the step: the later, the newer.
      }
      walk.step(schedule.time(frame), motion);
      Drawn drawn = view.draw(walk.world());
      head.submitted();
      head.log(walk.world().time());
      if (frame == 0) {
        view.finish();
        keeper.firstFrame(walk.polygons(), drawn);
        schedule.begin();
      } else {
        keeper.frame(walk.polygons(), drawn);
      }
    }
    view.finish();
  }

  private FrameSchedule schedule(HeadSession head) {
    if (settings.path().isPresent()) {
      return FrameSchedule.path(settings, settings.path().get());
    }
    if (head.replayed().isPresent()) {
      double end = settings.duration().orElse(head.replayed().getAsDouble());
      return FrameSchedule.of(new PathClock(0, end, RunSettings.PATH_RATE));
    }
    return FrameSchedule.wall(settings.duration().orElse(0));
  }
}
