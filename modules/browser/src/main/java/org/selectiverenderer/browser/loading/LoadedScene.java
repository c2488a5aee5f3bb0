package org.selectiverenderer.browser.loading;

import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.scene.Scene;

/**
 * A scene ready to run.
 *
 * @param loader the loader that made the scene and that reads what its Inlines and textures name
 *     while it runs
 */
public record LoadedScene(Scene scene, SceneLoader loader) {
  /** Returns the assets of the scene's nodes. */
  public AssetProvider assets() {
    return loader.assets();
  }
}
