package org.selectiverenderer.render.lighting;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The key of a drawn mesh: shapes with equal keys share the mesh.
 *
 * @param fineness the tolerance that the mesh is refined to, in its own coordinates
 * @param place an identity of the place and the lights that the mesh is refined for; null where
 *     they do not matter
 */
public record RefinedMeshKey(Mesh source, CurvatureTolerance fineness, @Nullable Object place) {
  /** Returns the key of a mesh that is not refined. */
  public static RefinedMeshKey plain(Mesh source) {
    return new RefinedMeshKey(source, CurvatureTolerance.NONE, null);
  }

  /** Returns whether the mesh is drawn as it is. */
  public boolean isPlain() {
    return fineness.equals(CurvatureTolerance.NONE) && place == null;
  }
}
