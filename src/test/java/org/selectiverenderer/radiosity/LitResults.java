package org.selectiverenderer.radiosity;

import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.radiosity.bake.LitScene;
import org.selectiverenderer.radiosity.bake.TexelScene;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;
import org.selectiverenderer.radiosity.work.WorkProgress;

/** Lit results for tests in other packages, as the command computes them. */
public final class LitResults {
  private LitResults() {}

  public static LitScene atVertices(LightScene scene, RadiositySettings settings)
      throws UnlitSceneException {
    return new Radiosity(settings, WorkProgress.NONE).light(scene, solution -> {});
  }

  /** With pictures for each file that shapes come from. */
  public static TexelScene inTextures(LightScene scene, RadiositySettings settings)
      throws UnlitSceneException {
    Map<String, Integer> files = new HashMap<>();
    int[] fileOf = new int[scene.bodies().size()];
    for (int i = 0; i < fileOf.length; i++) {
      String file = scene.bodies().get(i).shape().node().location().file();
      fileOf[i] = files.computeIfAbsent(file, key -> files.size());
    }
    return new TexelRadiosity(settings, WorkProgress.NONE, new Problems())
        .light(scene, fileOf, solution -> {});
  }
}
