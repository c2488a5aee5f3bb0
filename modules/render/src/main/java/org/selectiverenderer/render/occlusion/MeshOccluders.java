package org.selectiverenderer.render.occlusion;

import java.util.List;
import java.util.function.Supplier;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshTransformer;

/**
 * The occluders of a mesh: its large flat parts, which can hide other things. They are searched for
 * when the mesh first appears large on the screen, which few of a scene's meshes ever do. Made by
 * any thread, then used by the renderer's thread.
 */
public final class MeshOccluders {
  private final boolean solid;
  private final double reach;
  private final int triangles;
  private @Nullable Supplier<Mesh> mesh;
  private List<OccluderPolygon> patches = List.of();

  private MeshOccluders(boolean solid, double reach, int triangles, Supplier<Mesh> mesh) {
    this.solid = solid;
    this.reach = reach;
    this.triangles = triangles;
    this.mesh = triangles > 0 ? mesh : null;
  }

  /**
   * Returns the occluders of a mesh, which is kept until the search; lines and points hide nothing.
   */
  public static MeshOccluders of(Mesh mesh) {
    return new MeshOccluders(
        mesh.solid(), RasterErrorBounds.reach(mesh.bounds()), mesh.polygons(), () -> mesh);
  }

  /**
   * Returns the occluders of a mesh that was transformed; only the original mesh is kept and
   * transformed again for the search.
   *
   * @param bounds the bounding box of the placed mesh
   */
  public static MeshOccluders placed(Mesh mesh, Matrix4dc placement, float[] bounds) {
    return new MeshOccluders(
        mesh.solid(),
        RasterErrorBounds.reach(bounds),
        mesh.polygons(),
        () -> MeshTransformer.place(mesh, placement));
  }

  /** Returns whether it was searched and holds no occluder. */
  boolean none() {
    return mesh == null && patches.isEmpty();
  }

  /** Searches for occluders unless that is done; takes time in proportion to the triangles. */
  public void find() {
    if (mesh != null) {
      patches = new OccluderFinder(mesh.get()).find();
      mesh = null;
    }
  }

  /** Returns the number of triangles that {@link #find} would examine. */
  int unseen() {
    return mesh == null ? 0 : triangles;
  }

  /** Returns the occluder polygons, largest first; none before {@link #find}. */
  List<OccluderPolygon> patches() {
    return patches;
  }

  /** Returns whether only front faces are drawn, and so occlude. */
  boolean solid() {
    return solid;
  }

  /** Returns the largest distance of a vertex from the origin of the local coordinates. */
  double reach() {
    return reach;
  }

  /**
   * Returns a bound of the numbers that drawing the mesh at a place adds up, for {@link
   * OcclusionCuller#ask(double)}.
   *
   * @param place the matrix from the coordinates in its buffers to the world
   */
  public double terms(Matrix4dc place) {
    return RasterErrorBounds.terms(place, reach);
  }
}
