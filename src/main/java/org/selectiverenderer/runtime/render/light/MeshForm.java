package org.selectiverenderer.runtime.render.light;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The key of a drawn mesh: shapes with equal keys share the mesh.
 *
 * @param fineness the tolerance that the mesh is refined to, in its own coordinates
 * @param place an identity of the place and the lights that the mesh is refined for; null where
 *     they do not matter
 */
public record MeshForm(Mesh source, Fineness fineness, @Nullable Object place) {
  /** Returns the key of a mesh that is not refined. */
  static MeshForm plain(Mesh source) {
    return new MeshForm(source, Fineness.NONE, null);
  }

  boolean isPlain() {
    return fineness.equals(Fineness.NONE) && place == null;
  }
}
