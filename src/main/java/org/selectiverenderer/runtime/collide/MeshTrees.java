package org.selectiverenderer.runtime.collide;

import java.util.Map;
import java.util.WeakHashMap;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tree.MeshTree;

/**
 * A cache of the BVHs of a world's meshes. Each is built when first needed and dropped with its
 * mesh. Belongs to the thread that steps the world.
 */
public final class MeshTrees {
  // Two meshes are equal when they share their arrays, so that a weak map by equality is a map by
  // content.
  private final Map<Mesh, MeshTree> made = new WeakHashMap<>();

  public MeshTree of(Mesh mesh) {
    return made.computeIfAbsent(mesh, MeshTree::new);
  }
}
