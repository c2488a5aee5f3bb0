package org.selectiverenderer.render.context;

import com.jogamp.nativewindow.NativeWindowException;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLAutoDrawable;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLContext;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import java.awt.AWTError;

/**
 * A GL context without a window, current on the thread that opened it until that thread closes it.
 */
public final class OffscreenContext implements AutoCloseable {
  private final GLAutoDrawable drawable;
  private final GLContext context;

  private OffscreenContext(GLAutoDrawable drawable, GLContext context) {
    this.drawable = drawable;
    this.context = context;
  }

  /**
   * Opens a context of OpenGL 3.3 or newer, core profile.
   *
   * @throws GlUnavailableException if there is no display or no such OpenGL
   */
  public static OffscreenContext open() {
    GlAvailability.check()
        .ifPresent(
            reason -> {
              throw new GlUnavailableException(reason);
            });
    try {
      GLProfile profile = GlProfiles.core();
      GLDrawableFactory factory = GLDrawableFactory.getFactory(profile);
      GLAutoDrawable drawable =
          factory.createDummyAutoDrawable(null, true, new GLCapabilities(profile), null);
      drawable.display();
      GLContext context = drawable.getContext();
      if (context == null || context.makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) {
        drawable.destroy();
        throw new GlUnavailableException("the display gives no OpenGL 3.3 context");
      }
      // JOGL has cleared a default framebuffer, which a context without a surface does not have.
      context.getGL().glGetError();
      return new OffscreenContext(drawable, context);
    } catch (GLException | NativeWindowException | LinkageError | AWTError e) {
      // JOGL asks AWT for the display's state unless Java runs headless.
      throw new GlUnavailableException(
          "OpenGL 3.3 cannot be used on this display: " + e.getMessage(), e);
    }
  }

  public GL3 gl() {
    return context.getGL().getGL3();
  }

  public GlInfo info() {
    return GlInfo.of(gl());
  }

  @Override
  public void close() {
    context.release();
    drawable.destroy();
  }
}
