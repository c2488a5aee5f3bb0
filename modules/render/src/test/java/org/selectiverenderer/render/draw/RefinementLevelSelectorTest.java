package org.selectiverenderer.render.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.render.mesh.RefinementLevelRange;
import org.selectiverenderer.render.mesh.TriangleClusters;

class RefinementLevelSelectorTest {
  private static final TriangleClusters LAST = clusters(300);
  private static final TriangleClusters SOME = clusters(100);
  private static final TriangleClusters FEW = clusters(30);
  private static final List<RefinementLevelRange> COARSER =
      List.of(new RefinementLevelRange(FEW, 0.2), new RefinementLevelRange(SOME, 0.1));

  private static TriangleClusters clusters(int indices) {
    return new TriangleClusters(new int[] {0, indices}, new float[4], new float[4]);
  }

  /** A right angle wide in 200 pixels: at a distance of d a unit has 100 / d pixels. */
  private static Camera at(double z) {
    return new Camera(
        new Matrix4d().translation(0, 0, -z),
        new Matrix4d().setPerspective(Math.PI / 2, 1, 0.1, 100),
        0,
        0,
        200,
        200);
  }

  private static TriangleClusters seen(double scale, Camera... eyes) {
    RefinementLevelSelector stages = new RefinementLevelSelector();
    stages.begin(List.of(eyes));
    return stages.of(LAST, COARSER, new double[] {-1, -1, -1, 1, 1, 0}, scale);
  }

  @Test
  void whatIsSmallInThePictureIsDrawnWithFewTriangles() {
    assertThat(seen(1, at(0.5))).isSameAs(LAST);
    assertThat(seen(1, at(0.7))).isSameAs(SOME);
    assertThat(seen(1, at(1.2))).isSameAs(SOME);
    assertThat(seen(1, at(1.3))).isSameAs(FEW);
    assertThat(seen(3, at(1.3))).isSameAs(LAST);
  }

  @Test
  void theNearestEyeDecidesForAll() {
    assertThat(seen(1, at(9), at(0.7))).isSameAs(SOME);
    assertThat(seen(1, at(0.5), at(9))).isSameAs(LAST);
  }

  @Test
  void whatReachesBehindTheEyeIsDrawnInFull() {
    assertThat(seen(1, at(-0.5))).isSameAs(LAST);
    assertThat(seen(1, at(0))).isSameAs(LAST);
  }

  @Test
  void inAParallelViewDistanceDoesNotMatter() {
    for (int z = 1; z < 50; z += 10) {
      assertThat(seen(1, parallel(z, 1))).isSameAs(LAST);
      assertThat(seen(1, parallel(z, 1.25))).isSameAs(FEW);
    }
  }

  private static Camera parallel(double z, double half) {
    Matrix4d flat = new Matrix4d().setOrtho(-half, half, -half, half, 0.1, 100);
    Matrix4d view = new Matrix4d().translation(0, 0, -z);
    int size = half > 1 ? 100 : 400;
    return new Camera(view, flat, 0, 0, size, size);
  }
}
