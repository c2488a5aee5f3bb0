package org.selectiverenderer.runtime.loading;

import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.scene.Scene;

/**
 * A scene ready to run.
 *
 * @param assets the meshes and images of its nodes, made while loading
 */
public record LoadedScene(Scene scene, Assets assets) {}
