package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.app.settings.DisplaySettings;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.FrameStatistics;
import org.selectiverenderer.render.context.Screenshot;
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
    int samples = samples();
    // The context comes up while the scene is being read.
    try (OffscreenView view =
        OffscreenView.open(
            display.width(),
            display.height(),
            samples,
            display.presentation().layout(),
            display.style())) {
      run.awaitScene();
      run.opening();
      Optional<World> last = Optional.empty();
      for (int frame = 0; !run.finished(); frame++) {
        if (settings.tracker().tracked()) {
          view.awaitReady(); // The pose is read in the step; a late step reads a newer pose.
        }
        Optional<World> world = run.step();
        if (world.isEmpty()) {
          return LastPictures.NONE;
        }
        last = world;
        FrameStatistics drawn = view.draw(world.get());
        run.submitted();
        if (frame == 0) {
          view.finish();
        }
        run.drawn(drawn);
      }
      view.finish();
      int picture = display.pictureSamples(samples);
      Screenshot screenshot =
          last.isPresent() ? view.screenshot(last.get(), picture) : view.screenshot();
      return new LastPictures(view.info(), Optional.of(screenshot), Optional.empty());
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
