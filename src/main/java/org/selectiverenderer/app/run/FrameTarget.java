package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.context.Screenshot;

/** Where the frames of a run go. */
interface FrameTarget {
  /**
   * Takes frames from a run until it is over: lets it step, draws, says so.
   *
   * @throws IOException when the scene cannot be read
   * @throws InterruptedException if the thread is interrupted while it waits for the frames
   */
  LastPictures show(SceneRun run) throws IOException, InterruptedException;

  /**
   * What is left of the frames.
   *
   * @param gl what drew them
   * @param scene the last picture of the scene
   * @param operator the last picture of the operator's window
   */
  record LastPictures(GlInfo gl, Optional<Screenshot> scene, Optional<Screenshot> operator) {
    /** Nothing was drawn. */
    static final LastPictures NONE =
        new LastPictures(new GlInfo("", "", ""), Optional.empty(), Optional.empty());
  }
}
