package org.selectiverenderer.browser.collision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TestMeshes;

/** A hierarchy is built once, by the thread that comes first. */
class MeshBvhCacheTest {
  private final Mesh cube = TestMeshes.box(-1, -1, -1, 1, 1, 1);
  private final MeshBvhCache cache = new MeshBvhCache();

  @Test
  void whatAnotherThreadHasBuiltIsTaken() {
    List<MeshBvhCache.Task> tasks = cache.prepare(List.of(cube, cube));
    assertThat(tasks).hasSize(1);
    CompletableFuture.runAsync(tasks.get(0)).join();
    MeshBvh built = tasks.get(0).built();
    assertThat(cache.of(cube)).isSameAs(built);
    assertThat(cache.prepare(List.of(cube))).as("it is there").isEmpty();
  }

  @Test
  void whatIsNeededBeforeItsTurnIsBuiltAtOnce() {
    List<MeshBvhCache.Task> tasks = cache.prepare(List.of(cube));
    MeshBvh needed = cache.of(cube);
    tasks.get(0).run();
    assertThat(tasks.get(0).built()).isSameAs(needed);
    assertThat(cache.of(cube)).isSameAs(needed);
  }
}
