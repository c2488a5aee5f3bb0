package org.selectiverenderer.render.lighting;

import java.util.Objects;
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

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof RefinedMeshKey one
        && source.equals(one.source)
        && fineness.equals(one.fineness)
        && Objects.equals(place, one.place);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * source.hashCode() + fineness.hashCode()) + Objects.hashCode(place);
  }
}
