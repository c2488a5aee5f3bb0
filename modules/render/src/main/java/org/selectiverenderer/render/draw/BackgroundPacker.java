package org.selectiverenderer.render.draw;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.lighting.MeshMetrics;
import org.selectiverenderer.render.mesh.MeshPacker;
import org.selectiverenderer.render.mesh.PackedMesh;
import org.selectiverenderer.render.occlusion.MeshOccluders;

/**
 * Measures and packs large meshes on a thread of its own, {@code mesh-packer}, so that no frame
 * waits for them. The thread ends when there has been nothing to do for a second. Belongs to the
 * renderer's thread.
 */
final class BackgroundPacker {
  /** A mesh that is ready to be uploaded, with its occluders found. */
  record Packed(MeshMetrics survey, PackedMesh mesh, MeshOccluders occluders) {
    static Packed of(Mesh mesh, MeshMetrics survey) {
      MeshOccluders occluders = MeshOccluders.of(mesh);
      occluders.find();
      return new Packed(survey, MeshPacker.pack(mesh), occluders);
    }
  }

  private final Function<Mesh, MeshMetrics> survey;
  private final Map<Mesh, CompletableFuture<Packed>> jobs = new IdentityHashMap<>();
  private final ThreadPoolExecutor thread =
      new ThreadPoolExecutor(
          1, 1, 1, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), BackgroundPacker::thread);

  /**
   * @param survey measures a mesh; called on the thread
   */
  BackgroundPacker(Function<Mesh, MeshMetrics> survey) {
    this.survey = survey;
    thread.allowCoreThreadTimeOut(true);
  }

  private static Thread thread(Runnable work) {
    Thread made = new Thread(work, "mesh-packer");
    made.setDaemon(true);
    return made;
  }

  /** Returns whether a mesh is packed; if not, that is done meanwhile. */
  boolean ready(Mesh mesh) {
    return jobs.computeIfAbsent(
            mesh,
            of -> CompletableFuture.supplyAsync(() -> Packed.of(of, survey.apply(of)), thread))
        .isDone();
  }

  /**
   * Returns a mesh that is packed; null if it is not. It does not wait: many others may come before
   * it.
   */
  @Nullable Packed of(Mesh mesh) {
    CompletableFuture<Packed> job = jobs.get(mesh);
    return job == null || !job.isDone() || job.isCompletedExceptionally() ? null : job.join();
  }

  /** Forgets a mesh, which is then not packed unless that has begun. */
  void forget(Mesh mesh) {
    CompletableFuture<Packed> job = jobs.remove(mesh);
    if (job != null) {
      job.cancel(false);
    }
  }

  /** Forgets all meshes but some. */
  void keepOnly(Set<Mesh> wanted) {
    List.copyOf(jobs.keySet()).stream()
        .filter(mesh -> !wanted.contains(mesh))
        .forEach(this::forget);
  }

  /** Ends the thread once it has finished what it does. */
  void close() {
    thread.shutdownNow();
    jobs.clear();
  }
}
