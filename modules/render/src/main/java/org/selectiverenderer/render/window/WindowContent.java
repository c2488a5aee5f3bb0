package org.selectiverenderer.render.window;

import com.jogamp.opengl.GL3;

/**
 * The content of a window: what its render loop calls in each frame. All calls come from the render
 * thread.
 */
public interface WindowContent {
  /**
   * Called once before the window is shown. An action that shall run before the window is taken
   * away at the end of the process can be registered from here on.
   */
  default void opening() {}

  /** Called once, with the context current, before the first frame. */
  void start(GL3 gl);

  /** Called once after {@link #start}: how the display paces the frames. */
  default void paced(DisplayTiming timing) {}

  /**
   * Steps the world; called before each frame, after the input since the last frame.
   *
   * @return whether to go on; false closes the window
   */
  boolean step();

  /**
   * Called by the window system's thread when the user closes a window.
   *
   * @return whether it closes; otherwise the content ends the loop by {@link #step} when it wants
   *     to
   */
  default boolean closing() {
    return true;
  }

  /**
   * Returns whether the pointer is to be confined to the main window and hidden, so that nobody
   * clicks elsewhere. Asked in every frame; the window system releases the pointer when the program
   * ends.
   */
  default boolean pointerKept() {
    return false;
  }

  /** Draws a frame into the framebuffer that is bound. */
  void draw(GL3 gl, FrameSize size);

  /** Called when the frame last drawn has been handed to the display, in all windows. */
  default void submitted() {}

  /** Called once, with the context current, after the last frame; also when a frame failed. */
  void stop(GL3 gl);
}
