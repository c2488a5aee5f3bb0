package org.selectiverenderer.runtime.render.light;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * What a drawn mesh is made from: shapes with equal forms share it.
 *
 * @param fineness that it is refined to, in its own coordinates
 * @param place stands for the place and the lights it is refined for; null where they do not matter
 */
public record MeshForm(Mesh source, Fineness fineness, @Nullable Object place) {
  /** The mesh as it is. */
  static MeshForm plain(Mesh source) {
    return new MeshForm(source, Fineness.NONE, null);
  }

  boolean isPlain() {
    return fineness.equals(Fineness.NONE) && place == null;
  }
}
