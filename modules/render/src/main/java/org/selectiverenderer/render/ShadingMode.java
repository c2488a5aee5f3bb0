package org.selectiverenderer.render;

import org.selectiverenderer.render.context.GlInfo;

/** The choice between per-vertex (Gouraud) and per-pixel (Phong) shading. */
public enum ShadingMode {
  /** Per pixel on a graphics card, per vertex with a software renderer. */
  AUTO,
  /** Per vertex where that is not visible, on meshes refined where needed; else per pixel. */
  VERTEX,
  /** Per pixel everywhere. */
  PIXEL;

  /** Returns whether this mode means per-vertex lighting with that driver. */
  public boolean byVertex(GlInfo gl) {
    return this == VERTEX || (this == AUTO && gl.software());
  }

  /** Returns what {@link #AUTO} stands for with that driver: {@link #VERTEX} or {@link #PIXEL}. */
  public ShadingMode on(GlInfo gl) {
    return byVertex(gl) ? VERTEX : PIXEL;
  }
}
