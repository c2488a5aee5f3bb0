package org.selectiverenderer.models.simplify;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class MeshDeviationTest {
  private static MergedMesh joined(Mesh mesh) {
    return MergedMesh.of(List.of(mesh));
  }

  @Test
  void theErrorIsTheDistanceAsAShareOfTheExtent() {
    MergedMesh low = joined(TestMeshes.field(0, 30, (x, z) -> 0, false));
    MergedMesh high = joined(TestMeshes.field(0, 2, (x, z) -> 0.125, false));

    assertThat(new MeshDeviation(low).error(high)).isCloseTo(0.125, within(1e-7));
    assertThat(new MeshDeviation(low).error(low)).isCloseTo(0, within(1e-12));
  }

  @Test
  void aBumpThatIsGoneIsAnError() {
    MergedMesh bump =
        joined(TestMeshes.field(0, 40, (x, z) -> Math.abs(x - 0.5) < 0.01 ? 0.2 : 0, false));
    MergedMesh flat = joined(TestMeshes.field(0, 1, (x, z) -> 0, false));

    assertThat(new MeshDeviation(bump).error(flat)).isCloseTo(0.2, within(1e-6));
  }

  @Test
  void aSurfaceThatIsAPointIsNearToo() {
    MergedMesh point =
        new MergedMesh(new float[3 * MergedMesh.STRIDE], new int[] {0, 1, 2}, new int[] {0, 1, 2});
    assertThat(new TriangleBvh(point).nearest(0, 0, 0, 0, new double[1])).isZero();
  }

  @Test
  void theNearestTriangleIsTheOneThatAFullSearchFinds() {
    MergedMesh ball = joined(TestMeshes.ball(9, 14));
    TriangleBvh index = new TriangleBvh(ball);
    Random random = new Random(3);
    double[] square = new double[1];
    for (int i = 0; i < 500; i++) {
      double x = 3 * random.nextDouble() - 1.5;
      double y = 3 * random.nextDouble() - 1.5;
      double z = 3 * random.nextDouble() - 1.5;
      double least = Double.POSITIVE_INFINITY;
      for (int t = 0; t < ball.polygons(); t++) {
        least =
            Math.min(
                least, PointTriangleDistance.square(ball.vertices(), ball.indices(), t, x, y, z));
      }
      int found = index.nearest(x, y, z, -1, square);
      assertThat(square[0]).isCloseTo(least, within(1e-12));
      assertThat(index.square(found, x, y, z)).isEqualTo(square[0]);
      // Where to begin changes nothing.
      for (int near : new int[] {found, random.nextInt(ball.polygons())}) {
        assertThat(index.nearest(x, y, z, near, square)).isEqualTo(found);
      }
    }
  }
}
