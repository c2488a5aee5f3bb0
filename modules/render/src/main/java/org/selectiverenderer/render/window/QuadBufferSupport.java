package org.selectiverenderer.render.window;

import com.jogamp.opengl.GLCapabilitiesImmutable;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import org.selectiverenderer.render.context.GlProfiles;
import org.selectiverenderer.render.context.GlUnavailableException;

/** Tests whether the driver supports quad-buffered stereo: a left and a right buffer per window. */
public final class QuadBufferSupport {
  private QuadBufferSupport() {}

  /**
   * Returns whether the driver offers quad-buffered windows.
   *
   * @throws GlUnavailableException if there is no display or no OpenGL 3.3
   */
  public static boolean available() {
    try {
      GLProfile profile = GlProfiles.core();
      return GLDrawableFactory.getFactory(profile).getAvailableCapabilities(null).stream()
          .anyMatch(GLCapabilitiesImmutable::getStereo);
    } catch (GLException | LinkageError e) {
      throw new GlUnavailableException(
          "OpenGL 3.3 cannot be used on this display: " + e.getMessage(), e);
    }
  }
}
