package org.selectiverenderer.runtime.render.window;

import com.jogamp.opengl.GLCapabilitiesImmutable;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLException;
import com.jogamp.opengl.GLProfile;
import org.selectiverenderer.runtime.render.context.GlProfiles;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;

/** Whether windows have a left and a right buffer each. */
public final class QuadBuffers {
  private QuadBuffers() {}

  /**
   * Asks the driver.
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
