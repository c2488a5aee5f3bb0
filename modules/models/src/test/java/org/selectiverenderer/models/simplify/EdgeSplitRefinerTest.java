package org.selectiverenderer.models.simplify;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class EdgeSplitRefinerTest {
  private static Mesh split(Mesh mesh, int polygons) {
    MergedMesh joined = MergedMesh.of(List.of(mesh)).compact().asOriginal();
    MergedMesh split = EdgeSplitRefiner.upTo(polygons, joined, 1e6);
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        split.positions(),
        null,
        null,
        null,
        split.indices(),
        true,
        new float[6]);
  }

  @Test
  void aClosedSurfaceStaysClosedAndKeepsItsForm() {
    Mesh cube = TestMeshes.cube(1);

    Mesh more = split(cube, 60);

    assertThat(more.polygons()).isEqualTo(60);
    assertThat(TestMeshes.edges(more).values()).containsOnly(2);
    assertThat(TestMeshes.volume(more)).isCloseTo(1, within(1e-5));
    assertThat(TestMeshes.area(more)).isCloseTo(6, within(1e-5));
  }

  @Test
  void aClosedSurfaceHasAnEvenCount() {
    assertThat(split(TestMeshes.cube(1), 15).polygons()).isEqualTo(14);
  }

  @Test
  void aBorderMakesOddCountsPossible() {
    Mesh square = TestMeshes.field(0, 1, (x, z) -> 0, false);

    for (int polygons = 2; polygons < 12; polygons++) {
      Mesh more = split(square, polygons);
      assertThat(more.polygons()).isEqualTo(polygons);
      assertThat(TestMeshes.area(more)).isCloseTo(1, within(1e-5));
    }
  }
}
