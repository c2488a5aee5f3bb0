package org.selectiverenderer.runtime.render.occlude;

import java.util.List;
import java.util.function.Supplier;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshPlacement;

/**
 * What of a mesh can hide other things: its large flat parts. They are looked for when the mesh is
 * first seen large; few of a scene's meshes ever are. Made by any thread, then the renderer's.
 */
public final class Occluders {
  private final boolean solid;
  private final double reach;
  private final int triangles;
  private @Nullable Supplier<Mesh> mesh;
  private List<Patch> patches = List.of();

  private Occluders(boolean solid, double reach, int triangles, Supplier<Mesh> mesh) {
    this.solid = solid;
    this.reach = reach;
    this.triangles = triangles;
    this.mesh = triangles > 0 ? mesh : null;
  }

  /** Of a mesh, which it keeps until it has looked; lines and points hide nothing. */
  public static Occluders of(Mesh mesh) {
    return new Occluders(mesh.solid(), Precision.reach(mesh.bounds()), mesh.polygons(), () -> mesh);
  }

  /**
   * Of a mesh that has been placed elsewhere, which is done again when it is looked at: only the
   * mesh as it was is kept.
   *
   * @param bounds of the placed mesh
   */
  public static Occluders placed(Mesh mesh, Matrix4dc placement, float[] bounds) {
    return new Occluders(
        mesh.solid(),
        Precision.reach(bounds),
        mesh.polygons(),
        () -> MeshPlacement.place(mesh, placement));
  }

  /** Whether there is nothing in it, as far as it was looked. */
  boolean none() {
    return mesh == null && patches.isEmpty();
  }

  /** Looks, unless that is done; takes time in proportion to the triangles. */
  void find() {
    if (mesh != null) {
      patches = new PatchFinder(mesh.get()).find();
      mesh = null;
    }
  }

  /** How many triangles {@link #find} would look at. */
  int unseen() {
    return mesh == null ? 0 : triangles;
  }

  /** The largest first; none before {@link #find}. */
  List<Patch> patches() {
    return patches;
  }

  /** Whether only fronts are drawn, and so hide. */
  boolean solid() {
    return solid;
  }

  /** The distance from the origin of local coordinates that no vertex exceeds. */
  double reach() {
    return reach;
  }
}
