package org.selectiverenderer.radiosity.bake;

import java.util.List;
import java.util.Map;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.texel.IrradianceAtlas;

/**
 * A scene with its light in lightmaps.
 *
 * @param divided facets of the bodies that are written with more polygons than they have, by body
 * @param curve the tone mapping from light to display colours
 * @param rays number of rays cast
 */
public record LightmappedScene(
    RadiosityScene scene,
    IrradianceAtlas pages,
    Map<Integer, List<Facet>> divided,
    RadiositySolution solution,
    ReinhardToneMapping curve,
    long rays)
    implements LightingResult {

  public Atlas atlas() {
    return pages.atlas();
  }

  @Override
  public boolean complete() {
    return pages.complete();
  }

  @Override
  public int polygons() {
    int sum = 0;
    for (int i = 0; i < scene.bodies().size(); i++) {
      List<Facet> parts = divided.get(i);
      sum += parts == null ? scene.bodies().get(i).triangles() : parts.size();
    }
    return sum;
  }
}
