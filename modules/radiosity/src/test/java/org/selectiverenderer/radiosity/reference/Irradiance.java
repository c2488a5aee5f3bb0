package org.selectiverenderer.radiosity.reference;

import org.selectiverenderer.radiosity.bake.LightingResult;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.bake.VertexLitScene;

/** The light that a lit result has on the scene's surfaces. For several threads. */
@FunctionalInterface
interface Irradiance {
  /**
   * Irradiance at a place, lx.
   *
   * @param u weight of the triangle's second corner
   * @param v weight of its third corner
   * @param out gets r, g, b
   */
  void at(int triangle, double u, double v, double[] out);

  /** The light of a result, wherever it is stored. */
  static Irradiance of(LightingResult lit) {
    return lit instanceof LightmappedScene texels
        ? new PageIrradiance(texels)
        : new VertexIrradiance((VertexLitScene) lit);
  }
}
