package org.selectiverenderer.browser.collision;

import java.util.Map;
import java.util.WeakHashMap;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A cache of the BVHs of a world's meshes. Each is built when first needed and dropped with its
 * mesh. Belongs to the thread that steps the world.
 */
public final class MeshBvhCache {
  // Two meshes are equal when they share their arrays, so that a weak map by equality is a map by
  // content.
  private final Map<Mesh, MeshBvh> made = new WeakHashMap<>();

  /** Takes over hierarchies that were built before they are needed, as those of large meshes. */
  public void add(Map<Mesh, MeshBvh> built) {
    made.putAll(built);
  }

  public MeshBvh of(Mesh mesh) {
    return made.computeIfAbsent(mesh, MeshBvh::new);
  }
}
