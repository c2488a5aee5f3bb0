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

  /**
   * The user closes a window. Called by the window system's thread.
   *
   * @return whether it closes; else the source ends by {@link #step} once it wants to
   */
  default boolean closing() {
    return true;
  }

  /**
   * Whether the pointer is to stay in the main window, unseen, so that nobody presses anything
   * elsewhere. Asked in every frame; the window system lets go of it when the program is gone.
   */
  default boolean pointerKept() {
    return false;
  }

  /** Draws a frame into the frame buffer that is bound. */
  void draw(GL3 gl, FrameSize size);

  /** The frame last drawn was handed to the display, in all windows. */
  default void submitted() {}

  /** Once, with the context current, after the last frame; also when a frame failed. */
  void stop(GL3 gl);
}
