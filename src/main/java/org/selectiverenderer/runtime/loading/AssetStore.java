package org.selectiverenderer.runtime.loading;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.runtime.instance.Assets;
import org.selectiverenderer.runtime.instance.Texture;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.geometry.Mesh;

/**
 * Meshes and images by node: those made while loading, and those made later for nodes that are new
 * or changed. Thread-safe.
 */
final class AssetStore implements Assets {
  private final Map<Node, Optional<Mesh>> meshes = new IdentityHashMap<>();
  private final Map<Node, Optional<Texture.Image>> images = new IdentityHashMap<>();
  private final Function<Node, Optional<Mesh>> tessellate;
  private final Function<Node, Optional<Texture.Image>> decode;

  AssetStore(
      Function<Node, Optional<Mesh>> tessellate, Function<Node, Optional<Texture.Image>> decode) {
    this.tessellate = tessellate;
    this.decode = decode;
  }

  synchronized void put(Node geometry, Optional<Mesh> mesh) {
    meshes.put(geometry, mesh);
  }

  synchronized void putImage(Node texture, Optional<Texture.Image> image) {
    images.put(texture, image);
  }

  @Override
  public synchronized Optional<Mesh> mesh(Node geometry) {
    return meshes.computeIfAbsent(geometry, tessellate);
  }

  @Override
  public synchronized Optional<Texture.Image> image(Node texture) {
    return images.computeIfAbsent(texture, decode);
  }

  @Override
  public synchronized void changed(Node geometryOrTexture) {
    meshes.remove(geometryOrTexture);
    images.remove(geometryOrTexture);
  }
}
