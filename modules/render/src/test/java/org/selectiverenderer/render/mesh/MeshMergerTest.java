package org.selectiverenderer.render.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class MeshMergerTest {
  private static Mesh triangle(float x, boolean solid) {
    float[] positions = {x, 0, 0, x + 1, 0, 0, x, 1, 0};
    int[] indices = {0, 1, 2};
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        positions,
        null,
        null,
        null,
        indices,
        solid,
        Mesh.boundsOf(positions, indices));
  }

  @Test
  void eachPartsIndicesNameItsOwnVertices() {
    MeshMerger.Merged merged =
        MeshMerger.merge(
            List.of(MeshPacker.pack(triangle(5, true)), MeshPacker.pack(triangle(7, true))));

    PackedMesh mesh = merged.mesh();
    assertThat(mesh.indexCount()).isEqualTo(6);
    assertThat(mesh.wideIndices()).isFalse();
    for (int part = 0; part < 2; part++) {
      int first = merged.parts().get(part).clusters().firstIndex()[0];
      assertThat(first).isEqualTo(3 * part);
      int vertex = Short.toUnsignedInt(mesh.indices().getShort(2 * first));
      assertThat(mesh.vertices().getFloat(vertex * mesh.layout().stride())).isEqualTo(5 + 2 * part);
    }
  }

  @Test
  void clustersKeepTheirSpheresAndFollowOneAnother() {
    PackedMesh ball = MeshPacker.pack(MeshPackerTest.ball(40, 60));

    MeshMerger.Merged merged = MeshMerger.merge(List.of(ball, ball));

    TriangleClusters second = merged.parts().get(1).clusters();
    assertThat(second.size()).isEqualTo(ball.clusters().size()).isGreaterThan(1);
    assertThat(second.spheres()).isEqualTo(ball.clusters().spheres());
    assertThat(second.indexCount()).isEqualTo(ball.indexCount());
    for (int i = 0; i <= second.size(); i++) {
      assertThat(second.firstIndex()[i])
          .isEqualTo(ball.indexCount() + ball.clusters().firstIndex()[i]);
    }
  }

  @Test
  void stagesFollowTheWholeOfAllMeshesAndNameTheirOwnVertices() {
    List<PackedMesh> meshes = List.of(staged(5), MeshPacker.pack(triangle(6, true)), staged(7));

    MeshMerger.Merged merged = MeshMerger.merge(meshes);

    assertThat(merged.mesh().indexCount()).isEqualTo(21);
    assertThat(merged.parts().get(1).coarser()).isEmpty();
    for (int part = 0; part < 3; part += 2) {
      RefinementLevelRange coarser = merged.parts().get(part).coarser().get(0);
      assertThat(coarser.undivided()).isEqualTo(5 + part);
      assertThat(coarser.clusters().firstIndex())
          .containsExactly(15 + 3 * part / 2, 18 + 3 * part / 2);
      int first = coarser.clusters().firstIndex()[0];
      int vertex = Short.toUnsignedInt(merged.mesh().indices().getShort(2 * first));
      int stride = merged.mesh().layout().stride();
      assertThat(merged.mesh().vertices().getFloat(vertex * stride)).isEqualTo(5 + part);
    }
  }

  /** A triangle twice, with a stage before of which it is there once. */
  private static PackedMesh staged(float x) {
    Mesh mesh = triangle(x, true);
    Mesh twice =
        new Mesh(
            mesh.primitive(),
            mesh.positions(),
            mesh.normals(),
            null,
            null,
            new int[] {0, 1, 2, 0, 1, 2},
            true,
            mesh.bounds());
    return MeshPacker.pack(
        new RefinedMesh(twice, List.of(new RefinedMesh.Stage(new int[] {0, 1, 2}, x))));
  }

  @Test
  void meshesOfTwoKindsAreRefused() {
    List<PackedMesh> meshes =
        List.of(MeshPacker.pack(triangle(0, true)), MeshPacker.pack(triangle(0, false)));

    assertThatThrownBy(() -> MeshMerger.merge(meshes)).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void moreVerticesThanShortIndicesCanNameAreRefused() {
    PackedMesh ball = MeshPacker.pack(MeshPackerTest.ball(200, 200));

    assertThatThrownBy(() -> MeshMerger.merge(List.of(ball, ball)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("65536");
  }
}
