package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;

/** The result of lighting a scene, with light stored at vertices or at texels. */
public sealed interface Lit permits LitScene, TexelScene {
  LightScene scene();

  Solution solution();

  /** Returns the tone mapping from light to display colours. */
  ToneCurve curve();

  /** Returns the number of rays cast. */
  long rays();

  /** Returns whether the work ran to its end without being cancelled. */
  boolean complete();

  /** Returns the number of polygons that are written, versions included. */
  int polygons();
}
