package org.selectiverenderer.render.headset;

/** The window system's handles of an OpenGL context and its surface. */
public sealed interface GlContextHandles {
  /**
   * X11 with GLX.
   *
   * @param visual id of the X visual, never 0
   */
  record Glx(long display, int visual, long fbConfig, long drawable, long context)
      implements GlContextHandles {}

  /** Windows: HDC and HGLRC. */
  record Wgl(long device, long context) implements GlContextHandles {}
}
