package org.selectiverenderer.app.run;

import java.io.IOException;

/** A frame target that steps the run without drawing, and needs no display. */
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
