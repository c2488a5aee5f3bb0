package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.display.OffscreenView;

/**
 * A frame target that draws into an off-screen buffer as fast as possible. The calling thread steps
 * and draws.
 */
final class OffscreenFrameTarget implements FrameTarget {
  private final RunSettings settings;

  OffscreenFrameTarget(RunSettings settings) {
    this.settings = settings;
  }

  @Override
  public LastPictures show(SceneRun run) throws IOException {
    DisplaySettings display = settings.display();
    // The context comes up while the scene is being read.
    try (OffscreenView view =
        OffscreenView.open(
            display.width(),
            display.height(),
            samples(),
            display.presentation().layout(),
            display.style())) {
      run.awaitScene();
      run.opening();
      for (int frame = 0; !run.finished(); frame++) {
        if (settings.tracker().tracked()) {
          view.awaitReady(); // The pose is read in the step; a late step reads a newer pose.
        }
        Optional<World> world = run.step();
        if (world.isEmpty()) {
          return LastPictures.NONE;
        }
        FrameStatistics drawn = view.draw(world.get());
        run.submitted();
        if (frame == 0) {
          view.finish();
        }
        run.drawn(drawn);
      }
      view.finish();
      return new LastPictures(view.info(), Optional.of(view.screenshot()), Optional.empty());
    }
  }

  /**
   * Returns the samples of anti-aliasing: many for a single picture, fewer for a sequence of
   * frames.
   */
  private int samples() {
    boolean still =
        settings.motion().path().isEmpty()
            && settings.duration().isEmpty()
            && !settings.tracker().tracked();
    return settings
        .display()
        .samples()
        .orElseGet(() -> still ? AntiAliasing.SMOOTH : AntiAliasing.forMotion());
  }
}
