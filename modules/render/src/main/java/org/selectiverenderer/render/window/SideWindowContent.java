package org.selectiverenderer.render.window;

import com.jogamp.opengl.GL3;

/** The content of a window beside the main one. All calls come from the render thread. */
public interface SideWindowContent {
  /** Returns whether there is something new to show; asked after each frame of the main window. */
  boolean wanted();

  /** Draws into the framebuffer that is bound, in this window's own context. */
  void draw(GL3 gl, FrameSize size);

  /** Called once, with this window's context current, after the last frame. */
  void stop(GL3 gl);
}
