package org.selectiverenderer.app.run;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.Screenshot;

/** The destination of a run's frames: a window, a headset, an off-screen buffer, or none. */
interface FrameTarget {
  /**
   * Steps a run and draws its frames until the run is over.
   *
   * @throws IOException when the scene cannot be read
   * @throws InterruptedException if the thread is interrupted while it waits for the frames
   */
  LastPictures show(SceneRun run) throws IOException, InterruptedException;

  /**
   * The last pictures of a run.
   *
   * @param gl the OpenGL implementation that drew them
   * @param scene the last picture of the scene
   * @param operator the last picture of the operator's window
   */
  record LastPictures(GlInfo gl, Optional<Screenshot> scene, Optional<Screenshot> operator) {
    /** The value when nothing was drawn. */
    static final LastPictures NONE =
        new LastPictures(new GlInfo("", "", ""), Optional.empty(), Optional.empty());
  }
}
