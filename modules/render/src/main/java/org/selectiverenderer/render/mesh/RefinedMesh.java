package org.selectiverenderer.render.mesh;

import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A triangle mesh with its refinement levels. All levels have the same surface and share the same
 * vertices; a coarser level looks the same where the edges that it does not split are short on the
 * screen.
 *
 * @param mesh the finest level
 * @param coarser the coarser levels, fewest triangles first; none for a mesh that was not refined
 */
public record RefinedMesh(Mesh mesh, List<Stage> coarser) {
  /**
   * One of the coarser levels.
   *
   * @param indices three per triangle, into the vertices of the mesh
   * @param undivided the longest of its edges that finer levels split, in the mesh's coordinates
   */
  public record Stage(int[] indices, double undivided) {}

  /** Returns a mesh that was not refined. */
  public static RefinedMesh of(Mesh mesh) {
    return new RefinedMesh(mesh, List.of());
  }

  /** Returns the number of indices of the coarsest level. */
  public int least() {
    return coarser.isEmpty() ? mesh.indexCount() : coarser.get(0).indices().length;
  }
}
