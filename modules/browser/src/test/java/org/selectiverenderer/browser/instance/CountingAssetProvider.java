package org.selectiverenderer.browser.instance;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.shader.ShaderSource;

/**
 * Meshes with as many triangles as a Box is wide, or as the first coordinate of other geometry
 * says; counts its calls.
 */
final class CountingAssetProvider implements AssetProvider {
  int meshes;
  int made;
  private final Map<Node, Mesh> kept = new IdentityHashMap<>();
  private final Map<Node, Integer> changes = new IdentityHashMap<>();

  @Override
  public Optional<Mesh> mesh(Node geometry) {
    meshes++;
    return Optional.of(kept.computeIfAbsent(geometry, this::make));
  }

  private Mesh make(Node geometry) {
    made++;
    float[] size =
        geometry.type().name().equals("Box")
            ? geometry.floats("size")
            : geometry.node("coord").floats("point");
    int[] indices = new int[3 * (int) size[0]];
    float[] box = {0, 0, 0, size[0], size[1], size[2]};
    return new Mesh(Mesh.Primitive.TRIANGLES, new float[9], null, null, null, indices, true, box);
  }

  @Override
  public Optional<Texture.Image> image(Node texture) {
    return Optional.empty();
  }

  @Override
  public Optional<ShaderSource> shader(Node part) {
    return Optional.empty();
  }

  @Override
  public void told(Problem problem) {
    throw new AssertionError(problem);
  }

  @Override
  public boolean multiplies(Node texture) {
    return false;
  }

  @Override
  public void asOf(Node node, int changes) {
    if (!Objects.equals(this.changes.put(node, changes), changes)) {
      changed(node);
    }
  }

  @Override
  public void changed(Node node) {
    kept.remove(node);
  }
}
