package org.selectiverenderer.runtime.nodes.particle;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tessellate.VertexMeshes;
import org.selectiverenderer.runtime.scene.Node;

/**
 * What one system has prepared of the meshes that it emits from and bounces off, so that a frame
 * only looks whether they are still the same.
 */
final class KnownMeshes {
  private static final int KEPT = 8;

  /** Compared by identity: a mesh is another object when it has changed. */
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
  private final Map<Key, Optional<SurfacePoints>> surfaces =
      new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Key, Optional<SurfacePoints>> eldest) {
          return size() > KEPT;
        }
      };

  /**
   * @param meshes of geometry nodes
   */
  KnownMeshes(Function<Node, Optional<Mesh>> meshes) {
    this.meshes = meshes;
  }

  /** The surface of a geometry node; nothing when it has none. */
  Optional<SurfacePoints> surface(@Nullable Node geometry) {
    return Optional.ofNullable(geometry)
        .flatMap(meshes)
        .flatMap(
            mesh -> surfaces.computeIfAbsent(new Key(mesh, null), key -> SurfacePoints.of(mesh)));
  }

  /** The surface of faces as an IndexedFaceSet has them. */
  Optional<SurfacePoints> surface(float[] points, int[] coordIndex) {
    return surfaces.computeIfAbsent(
        new Key(points, coordIndex),
        key -> SurfacePoints.of(VertexMeshes.faces(points, coordIndex)));
  }

  /** The mesh of a geometry node. */
  Optional<Mesh> mesh(Node geometry) {
    return meshes.apply(geometry);
  }
}
