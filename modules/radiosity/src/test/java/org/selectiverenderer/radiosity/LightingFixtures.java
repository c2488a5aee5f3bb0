package org.selectiverenderer.radiosity;

import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** Lit results for tests in other packages, as the command computes them. */
public final class LightingFixtures {
  private LightingFixtures() {}

  public static VertexLitScene atVertices(RadiosityScene scene, RadiositySettings settings)
      throws RadiosityException {
    return new VertexLightBaker(settings, RadiosityProgress.NONE).light(scene, solution -> {});
  }

  /** With pictures for each file that shapes come from. */
  public static LightmappedScene inTextures(RadiosityScene scene, RadiositySettings settings)
      throws RadiosityException {
    Map<String, Integer> files = new HashMap<>();
    int[] fileOf = new int[scene.bodies().size()];
    for (int i = 0; i < fileOf.length; i++) {
      String file = scene.bodies().get(i).shape().node().location().file();
      fileOf[i] = files.computeIfAbsent(file, key -> files.size());
    }
    return new LightmapBaker(settings, RadiosityProgress.NONE, new ProblemCollector())
        .light(scene, fileOf, solution -> {});
  }
}
