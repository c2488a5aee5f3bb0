package org.selectiverenderer.browser.nodes.particle;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.tessellate.MeshFactory;

/**
 * A cache of the sampling tables and BVHs of the meshes that a particle system emits from and
 * bounces off.
 */
final class SurfaceMeshCache {
  private static final int KEPT = 8;

  /** Compared by identity: a changed mesh is another object. */
  private record Key(Object one, @Nullable Object two) {
    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Key key && key.one == one && key.two == two;
    }

    @Override
    public int hashCode() {
      return 31 * System.identityHashCode(one) + System.identityHashCode(two);
    }
  }

  private final Function<Node, Optional<Mesh>> meshes;
  private final Map<Key, Optional<SurfacePointSampler>> surfaces =
      new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Key, Optional<SurfacePointSampler>> eldest) {
          return size() > KEPT;
        }
      };

  /**
   * @param meshes the meshes of geometry nodes
   */
  SurfaceMeshCache(Function<Node, Optional<Mesh>> meshes) {
    this.meshes = meshes;
  }

  /** Returns the surface of a geometry node; empty if it has none. */
  Optional<SurfacePointSampler> surface(@Nullable Node geometry) {
    return Optional.ofNullable(geometry)
        .flatMap(meshes)
        .flatMap(
            mesh ->
                surfaces.computeIfAbsent(new Key(mesh, null), key -> SurfacePointSampler.of(mesh)));
  }

  /** Returns the surface of faces given as in an IndexedFaceSet. */
  Optional<SurfacePointSampler> surface(float[] points, int[] coordIndex) {
    return surfaces.computeIfAbsent(
        new Key(points, coordIndex),
        key -> SurfacePointSampler.of(MeshFactory.faces(points, coordIndex)));
  }

  /** Returns the mesh of a geometry node. */
  Optional<Mesh> mesh(Node geometry) {
    return meshes.apply(geometry);
  }
}
