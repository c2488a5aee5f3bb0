package org.selectiverenderer.radiosity;

import org.selectiverenderer.radiosity.bake.LitScene;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;
import org.selectiverenderer.radiosity.work.WorkProgress;

/** The lit result for tests in other packages, as the command computes it. */
public final class LitByVertices {
  private LitByVertices() {}

  public static LitScene light(LightScene scene, RadiositySettings settings)
      throws UnlitSceneException {
    return new Radiosity(settings, WorkProgress.NONE).light(scene, solution -> {});
  }
}
