package org.selectiverenderer.runtime.render.show;

import java.util.Optional;
import org.selectiverenderer.runtime.render.context.GlInfo;
import org.selectiverenderer.runtime.render.context.Screenshot;

/** What shows a world until its host is finished: windows, or a headset with a mirror. */
public interface WorldScreen {
  /**
   * Shows the world until the user closes a window or the host is finished. Called once.
   *
   * @throws org.selectiverenderer.runtime.render.context.GlUnavailableException if there is no
   *     display or no OpenGL 3.3
   * @throws InterruptedException if the waiting thread is interrupted; everything is closed
   */
  void run() throws InterruptedException;

  /** What draws; empty before anything opened. */
  Optional<GlInfo> info();

  /**
   * The last picture of the world, without the overlay, both eyes' where there are two; empty when
   * it was never drawn.
   */
  Optional<Screenshot> lastPicture();

  /** The last picture of the operator's window. */
  Optional<Screenshot> lastOperatorPicture();
}
