package org.selectiverenderer.app.run;

import java.io.IOException;

/** Draws nothing, and needs no display. */
final class NoFrames implements FrameTarget {
  @Override
  public LastPictures show(SceneRun run) throws IOException {
    run.awaitScene();
    do {
      run.step();
      run.submitted();
    } while (!run.finished());
    return LastPictures.NONE;
  }
}
