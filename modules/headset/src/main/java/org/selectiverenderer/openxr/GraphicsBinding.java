package org.selectiverenderer.openxr;

/**
 * The graphics binding of a session: handles of the OpenGL context whose textures the runtime
 * shares.
 */
public sealed interface GraphicsBinding {
  /**
   * X11 with GLX ({@code XrGraphicsBindingOpenGLXlibKHR}).
   *
   * @param visual id of the X visual; runtimes refuse 0
   */
  record Xlib(long display, int visual, long fbConfig, long drawable, long context)
      implements GraphicsBinding {}

  /** Windows ({@code XrGraphicsBindingOpenGLWin32KHR}): HDC and HGLRC. */
  record Windows(long device, long context) implements GraphicsBinding {}
}
