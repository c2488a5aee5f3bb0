package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;

/** A scene with its light, wherever that is stored. */
public sealed interface Lit permits LitScene, TexelScene {
  LightScene scene();

  Solution solution();

  /** Makes colours of light. */
  ToneCurve curve();

  /** Cast in all. */
  long rays();

  /** Whether nothing was cancelled. */
  boolean complete();

  /** Polygons that are written, versions included. */
  int polygons();
}
