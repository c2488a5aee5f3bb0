package org.selectiverenderer.runtime.render;

import org.selectiverenderer.runtime.render.context.GlInfo;

/** Where the light of a shape is computed. */
public enum Shading {
  /** As suits what draws: at pixels on a graphics card, else at vertices. */
  AUTO,
  /** At vertices where nobody sees that, on meshes refined where needed; else at pixels. */
  VERTEX,
  /** At every pixel. */
  PIXEL;

  /** Whether it is computed at vertices on what draws. */
  public boolean byVertex(GlInfo gl) {
    return this == VERTEX || (this == AUTO && gl.software());
  }

  /** What it comes to there: {@link #VERTEX} or {@link #PIXEL}. */
  public Shading on(GlInfo gl) {
    return byVertex(gl) ? VERTEX : PIXEL;
  }
}
