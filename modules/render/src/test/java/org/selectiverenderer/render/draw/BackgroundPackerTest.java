package org.selectiverenderer.render.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.TestScene;
import org.selectiverenderer.render.lighting.LightingPlanner;

class BackgroundPackerTest {
  private static Mesh sphere() {
    return TestScene.of("<Shape><Sphere/></Shape>").tree().shapes().get(0).mesh().orElseThrow();
  }

  @Test
  @Timeout(30) // It would wait for ever.
  void whoeverNeedsAMeshNowDoesNotWaitForThoseBeforeIt() {
    LightingPlanner planner = new LightingPlanner(true);
    CountDownLatch done = new CountDownLatch(1);
    BackgroundPacker packer =
        new BackgroundPacker(
            mesh -> {
              try {
                done.await();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
              return planner.survey(mesh);
            });
    List<Mesh> meshes = List.of(sphere(), sphere());
    meshes.forEach(packer::ready);
    assertThat(packer.of(meshes.get(1))).isNull();
    done.countDown();
    packer.close();
  }
}
