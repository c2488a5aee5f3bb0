package org.selectiverenderer.render.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.render.mesh.Clusters;
import org.selectiverenderer.render.mesh.CoarserLevel;

class RefinementLevelSelectorTest {
  private static final Clusters LAST = clusters(300);
  private static final Clusters SOME = clusters(100);
  private static final Clusters FEW = clusters(30);
  private static final List<CoarserLevel> COARSER =
      List.of(new CoarserLevel(FEW, 0.2), new CoarserLevel(SOME, 0.1));

  private static Clusters clusters(int indices) {
    return new Clusters(new int[] {0, indices}, new float[4], new float[4]);
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

  private static Clusters seen(double scale, Camera... eyes) {
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
