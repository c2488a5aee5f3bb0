package org.selectiverenderer.render;

import com.jogamp.opengl.GLException;
import org.selectiverenderer.render.context.GlProfiles;
import org.selectiverenderer.render.context.GlUnavailableException;

/** The default number of samples per pixel for multisample anti-aliasing. */
public final class AntiAliasing {
  /** The samples per pixel with which edges look smooth. */
  public static final int SMOOTH = 4;

  private AntiAliasing() {}

  /**
   * Returns {@value #SMOOTH} on a graphics card, and 0 for a software renderer, where light that is
   * computed for every sample makes frames five times as long.
   *
   * @throws GlUnavailableException if there is no display or no OpenGL 3.3
   */
  public static int forMotion() {
    try {
      return GlProfiles.core().isHardwareRasterizer() ? SMOOTH : 0;
    } catch (GLException | LinkageError e) {
      throw new GlUnavailableException(
          "OpenGL 3.3 cannot be used on this display: " + e.getMessage(), e);
    }
  }
}
