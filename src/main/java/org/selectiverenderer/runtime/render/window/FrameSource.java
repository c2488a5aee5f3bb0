package org.selectiverenderer.runtime.render.window;

import com.jogamp.opengl.GL3;

/** What a window shows. All calls come from the render thread. */
public interface FrameSource {
  /** Once, with the context current, before the first frame. */
  void start(GL3 gl);

  /**
   * Before each frame, after the input that came since the last: steps the world.
   *
   * @return whether to go on; false closes the window
   */
  boolean step();

  /** Draws a frame into the frame buffer that is bound. */
  void draw(GL3 gl, FrameSize size);

  /** The frame last drawn was handed to the display, in all windows. */
  default void submitted() {}

  /** Once, with the context current, after the last frame; also when a frame failed. */
  void stop(GL3 gl);
}
