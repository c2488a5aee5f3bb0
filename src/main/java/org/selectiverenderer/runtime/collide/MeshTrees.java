package org.selectiverenderer.runtime.collide;

import java.util.Map;
import java.util.WeakHashMap;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tree.MeshTree;

/**
 * The hierarchies of the meshes of a world, each made when it is first asked for and forgotten with
 * its mesh. Belongs to the thread that steps the world.
 */
public final class MeshTrees {
  // Two meshes are equal when they share their arrays: equality of what lies at the same place.
  private final Map<Mesh, MeshTree> made = new WeakHashMap<>();

  public MeshTree of(Mesh mesh) {
    return made.computeIfAbsent(mesh, MeshTree::new);
  }
}
