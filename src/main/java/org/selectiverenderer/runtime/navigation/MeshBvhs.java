package org.selectiverenderer.runtime.navigation;

import java.util.Map;
import java.util.WeakHashMap;
import org.selectiverenderer.x3d.geometry.Mesh;

/**
 * The hierarchies of the meshes of a world, each made when it is first asked for and forgotten with
 * its mesh. Belongs to the thread that steps the world.
 */
public final class MeshBvhs {
  // Two meshes are equal when they share their arrays: equality of what lies at the same place.
  private final Map<Mesh, MeshBvh> made = new WeakHashMap<>();

  public MeshBvh of(Mesh mesh) {
    return made.computeIfAbsent(mesh, MeshBvh::new);
  }
}
