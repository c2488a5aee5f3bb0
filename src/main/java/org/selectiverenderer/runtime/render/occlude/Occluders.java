package org.selectiverenderer.runtime.render.occlude;

import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/** What of a mesh can hide other things, found once. Immutable; safe for use by several threads. */
public final class Occluders {
  /** Of a mesh that hides nothing worth looking for. */
  public static final Occluders NONE = new Occluders(List.of(), true, 0);

  private final List<Patch> patches;
  private final boolean solid;
  private final double reach;

  private Occluders(List<Patch> patches, boolean solid, double reach) {
    this.patches = patches;
    this.solid = solid;
    this.reach = reach;
  }

  /** The large flat parts of a mesh. Takes time in proportion to its triangles. */
  public static Occluders of(Mesh mesh) {
    if (mesh.primitive() != Mesh.Primitive.TRIANGLES || mesh.isEmpty()) {
      return NONE;
    }
    List<Patch> patches = new PatchFinder(mesh).find();
    return patches.isEmpty()
        ? NONE
        : new Occluders(patches, mesh.solid(), Precision.reach(mesh.bounds()));
  }

  public boolean isEmpty() {
    return patches.isEmpty();
  }

  /** The largest first. */
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
