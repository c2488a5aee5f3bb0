package org.selectiverenderer.app.run;

import java.util.function.Function;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.show.WorldHost;
import org.selectiverenderer.runtime.render.show.WorldScreen;

/**
 * Shows frames in windows or in a headset, which open while the scene is being read; their thread
 * steps the run.
 */
final class WindowFrames implements FrameTarget {
  private final Function<WorldHost, WorldScreen> screens;

  /**
   * @param screens shows what a host steps
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
