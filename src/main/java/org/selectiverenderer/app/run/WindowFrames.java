package org.selectiverenderer.app.run;

import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.show.RunWindows;
import org.selectiverenderer.runtime.render.show.WorldWindow;

/**
 * Shows frames in windows, which open while the scene is being read; their thread steps the run.
 */
final class WindowFrames implements FrameTarget {
  private final RunWindows stage;

  WindowFrames(RunWindows stage) {
    this.stage = stage;
  }

  @Override
  public LastPictures show(SceneRun run) throws InterruptedException {
    WorldWindow window = new WorldWindow(stage, run);
    window.run();
    return new LastPictures(
        window.info().orElse(new GlInfo("", "", "")),
        window.lastPicture(),
        window.lastOperatorPicture());
  }
}
