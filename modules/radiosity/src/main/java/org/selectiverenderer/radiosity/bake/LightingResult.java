package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/** The result of lighting a scene, with light stored at vertices or at texels. */
public sealed interface LightingResult permits VertexLitScene, LightmappedScene {
  RadiosityScene scene();

  RadiositySolution solution();

  /** Returns the tone mapping from light to display colours. */
  ReinhardToneMapping curve();

  /** Returns the number of rays cast. */
  long rays();

  /** Returns whether the work ran to its end without being cancelled. */
  boolean complete();

  /** Returns the number of polygons that are written, versions included. */
  int polygons();
}
