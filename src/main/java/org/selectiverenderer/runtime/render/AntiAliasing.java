package org.selectiverenderer.runtime.render;

import com.jogamp.opengl.GLProfile;

/** How many samples per pixel smooth the edges where nobody asked for a number. */
public final class AntiAliasing {
  /** What edges need to look smooth. */
  public static final int SMOOTH = 4;

  private AntiAliasing() {}

  /**
   * {@value #SMOOTH} on a graphics card, none where a processor draws: there, lights that are
   * computed for every sample make frames five times as long. Touches GL, so a display is needed.
   */
  public static int forMotion() {
    return GLProfile.get(GLProfile.GL3).isHardwareRasterizer() ? SMOOTH : 0;
  }
}
