package org.selectiverenderer.render.display;

import java.util.Optional;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.render.window.DisplayTiming;

/** Shows a world until its host is finished: in windows, or in a headset with a mirror window. */
public interface WorldDisplay {
  /**
   * Shows the world until the user closes a window or the host is finished. Called once.
   *
   * @throws org.selectiverenderer.render.context.GlUnavailableException if there is no display or
   *     no OpenGL 3.3
   * @throws InterruptedException if the waiting thread is interrupted; everything is closed
   */
  void run() throws InterruptedException;

  /** Returns the OpenGL driver that draws; empty before anything was opened. */
  Optional<GlInfo> info();

  /** Returns how the window's frames are paced; empty before it, and for other displays. */
  default Optional<DisplayTiming> timing() {
    return Optional.empty();
  }

  /**
   * Returns the last picture of the world without the overlay, both eyes' in stereo; empty when it
   * was never drawn.
   */
  Optional<Screenshot> lastPicture();

  /** Returns the last picture of the operator's window. */
  Optional<Screenshot> lastOperatorPicture();
}
