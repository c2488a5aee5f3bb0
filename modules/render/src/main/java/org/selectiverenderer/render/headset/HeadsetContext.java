package org.selectiverenderer.render.headset;

import com.jogamp.nativewindow.AbstractGraphicsConfiguration;
import com.jogamp.nativewindow.CapabilitiesImmutable;
import com.jogamp.nativewindow.NativeWindowException;
import com.jogamp.nativewindow.VisualIDHolder.VIDType;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLContext;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import java.util.List;
import jogamp.opengl.x11.glx.X11GLXGraphicsConfiguration;
import org.selectiverenderer.render.context.GlProfiles;
import org.selectiverenderer.render.context.GlUnavailableException;

/**
 * A context of OpenGL 3.3 or newer on an offscreen surface (a pbuffer), current on the thread that
 * opened it until that thread closes it.
 */
final class HeadsetContext implements AutoCloseable {
  private final GLOffscreenAutoDrawable drawable;
  private final GLContext context;

  private HeadsetContext(GLOffscreenAutoDrawable drawable, GLContext context) {
    this.drawable = drawable;
    this.context = context;
  }

  /**
   * Opens a context.
   *
   * @throws GlUnavailableException if the display offers no such context
   */
  static HeadsetContext open() {
    try {
      GLProfile profile = GlProfiles.core();
      GLCapabilities wanted = new GLCapabilities(profile);
      wanted.setOnscreen(false);
      wanted.setPBuffer(true);
      wanted.setDoubleBuffered(false);
      GLOffscreenAutoDrawable drawable =
          GLDrawableFactory.getFactory(profile)
              .createOffscreenAutoDrawable(null, wanted, HeadsetContext::withVisual, 16, 16);
      drawable.display();
      GLContext context = drawable.getContext();
      if (context == null || context.makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) {
        drawable.destroy();
        throw new GlUnavailableException("the display gives no OpenGL 3.3 context");
      }
      return new HeadsetContext(drawable, context);
    } catch (GLException | NativeWindowException | LinkageError e) {
      throw new GlUnavailableException(
          "OpenGL 3.3 cannot be used for a headset on this display: " + e.getMessage(), e);
    }
  }

  /**
   * Chooses the first configuration that has an X visual, because OpenXR runtimes refuse a
   * configuration without one.
   */
  private static int withVisual(
      CapabilitiesImmutable wanted,
      List<? extends CapabilitiesImmutable> available,
      int recommended) {
    for (int i = 0; i < available.size(); i++) {
      CapabilitiesImmutable each = available.get(i);
      if (each.isVisualIDSupported(VIDType.X11_XVISUAL)
          && each.getVisualID(VIDType.X11_XVISUAL) != 0) {
        return i;
      }
    }
    return Math.max(0, recommended);
  }

  GL3 gl() {
    return context.getGL().getGL3();
  }

  /** Returns the native handles that an OpenXR runtime needs. */
  GlContextHandles handles() {
    AbstractGraphicsConfiguration configuration =
        drawable.getNativeSurface().getGraphicsConfiguration();
    if (configuration instanceof X11GLXGraphicsConfiguration x) {
      return new GlContextHandles.Glx(
          x.getScreen().getDevice().getHandle(),
          x.getVisualID(VIDType.X11_XVISUAL),
          x.getFBConfig(),
          drawable.getHandle(),
          context.getHandle());
    }
    return new GlContextHandles.Wgl(drawable.getHandle(), context.getHandle());
  }

  @Override
  public void close() {
    context.release();
    drawable.destroy();
  }
}
