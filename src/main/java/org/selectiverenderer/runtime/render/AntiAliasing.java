package org.selectiverenderer.runtime.render;

import com.jogamp.opengl.GLException;
import org.selectiverenderer.runtime.render.context.GlProfiles;
import org.selectiverenderer.runtime.render.context.GlUnavailableException;

/** How many samples per pixel smooth the edges where nobody asked for a number. */
public final class AntiAliasing {
  /** What edges need to look smooth. */
  public static final int SMOOTH = 4;

  private AntiAliasing() {}

  /**
   * {@value #SMOOTH} on a graphics card, none where a processor draws: there, lights that are
   * computed for every sample make frames five times as long.
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
