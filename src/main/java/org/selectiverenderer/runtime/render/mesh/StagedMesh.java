package org.selectiverenderer.runtime.render.mesh;

import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A mesh of triangles that was divided in stages. All stages have the same surface and take their
 * corners from the same vertices; the earlier ones are as good where what they do not divide yet is
 * small in the picture.
 *
 * @param mesh the last stage
 * @param coarser the stages before, fewest triangles first; none of a mesh that was not divided
 */
public record StagedMesh(Mesh mesh, List<Stage> coarser) {
  /**
   * One of the stages before the last.
   *
   * @param indices of its triangles, among the vertices of the mesh
   * @param undivided the longest edge in it that later stages divide, in the mesh's coordinates
   */
  public record Stage(int[] indices, double undivided) {}

  /** A mesh that was not divided. */
  public static StagedMesh of(Mesh mesh) {
    return new StagedMesh(mesh, List.of());
  }

  /** Indices of the stage with the fewest triangles. */
  public int least() {
    return coarser.isEmpty() ? mesh.indices().length : coarser.get(0).indices().length;
  }
}
