package org.selectiverenderer.browser.collision;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A cache of the BVHs of a world's meshes. Each is built when first needed, or before by another
 * thread, and dropped with its mesh. Belongs to the thread that steps the world.
 */
public final class MeshBvhCache {
  /** Builds one hierarchy, on any thread; whoever comes second waits for the first. */
  public static final class Task implements Runnable {
    private @Nullable Mesh mesh;
    private @Nullable MeshBvh built;

    private Task(Mesh mesh) {
      this.mesh = mesh;
    }

    @Override
    public void run() {
      built();
    }

    synchronized MeshBvh built() {
      MeshBvh done = built;
      if (done == null) {
        done = new MeshBvh(Objects.requireNonNull(mesh));
        built = done;
        mesh = null; // The weak maps can drop it.
      }
      return done;
    }
  }

  // Two meshes are equal when they share their arrays, so that a weak map by equality is a map by
  // content.
  private final Map<Mesh, MeshBvh> made = new WeakHashMap<>();
  private final Map<Mesh, Task> promised = new WeakHashMap<>();

  /** Takes over hierarchies that were built before they are needed, as those of large meshes. */
  public void add(Map<Mesh, MeshBvh> built) {
    made.putAll(built);
  }

  /**
   * Promises the hierarchies of meshes that have none yet.
   *
   * @return what builds them, to be run by other threads; one that is needed before is built then
   */
  public List<Task> prepare(Collection<Mesh> meshes) {
    List<Task> tasks = new ArrayList<>();
    for (Mesh mesh : meshes) {
      if (!made.containsKey(mesh) && !promised.containsKey(mesh)) {
        Task task = new Task(mesh);
        promised.put(mesh, task);
        tasks.add(task);
      }
    }
    return tasks;
  }

  public MeshBvh of(Mesh mesh) {
    return made.computeIfAbsent(mesh, this::build);
  }

  private MeshBvh build(Mesh mesh) {
    Task task = promised.remove(mesh);
    return task == null ? new MeshBvh(mesh) : task.built();
  }
}
