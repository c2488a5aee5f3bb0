package org.selectiverenderer.runtime.loading;

import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.scene.Scene;

/**
 * A scene ready to run.
 *
 * @param loader that made it, and reads what its Inlines and textures come to name while it runs
 */
public record LoadedScene(Scene scene, SceneLoader loader) {
  /** The meshes and images of its nodes. */
  public Assets assets() {
    return loader.assets();
  }
}
