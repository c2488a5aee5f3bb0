package org.selectiverenderer.app.run;

import java.util.function.Function;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.show.WorldHost;
import org.selectiverenderer.runtime.render.show.WorldScreen;

/**
 * A frame target that shows frames in windows or in a headset. These open while the scene is being
 * loaded, and their thread steps the run.
 */
final class WindowFrames implements FrameTarget {
  private final Function<WorldHost, WorldScreen> screens;

  /**
   * @param screens creates the screen that shows the world of a host
   */
  WindowFrames(Function<WorldHost, WorldScreen> screens) {
    this.screens = screens;
  }

  @Override
  public LastPictures show(SceneRun run) throws InterruptedException {
    WorldScreen window = screens.apply(run);
    window.run();
    return new LastPictures(
        window.info().orElse(new GlInfo("", "", "")),
        window.lastPicture(),
        window.lastOperatorPicture());
  }
}
