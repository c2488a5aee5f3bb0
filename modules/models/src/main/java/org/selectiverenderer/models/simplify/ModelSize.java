package org.selectiverenderer.models.simplify;

import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The number of vertices and polygons of a model.
 *
 * @param vertices number of distinct positions, summed over the parts (Max Vertex in thesis 2.2.4)
 * @param polygons number of triangles, summed over the parts
 */
public record ModelSize(int vertices, int polygons) {
  /**
   * @throws IllegalArgumentException if a part is not a triangle mesh
   */
  public static ModelSize of(List<Mesh> parts) {
    MergedMesh joined = MergedMesh.of(parts);
    return new ModelSize(PositionRemap.positions(joined), joined.polygons());
  }
}
