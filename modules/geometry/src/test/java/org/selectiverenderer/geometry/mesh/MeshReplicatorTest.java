package org.selectiverenderer.geometry.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;

class MeshReplicatorTest {
  private static final float[] CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  private static final int[] ONE = {0, 1, 2};

  private final Mesh triangle =
      new Mesh(
          Mesh.Primitive.TRIANGLES,
          CORNERS,
          new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1},
          null,
          new float[] {0, 0, 1, 0, 0, 1},
          ONE,
          true,
          Mesh.boundsOf(CORNERS, ONE));

  @Test
  void aMirroredCopyIsWoundTheOtherWayRound() {
    Mesh both =
        MeshReplicator.of(
            triangle, List.of(new Matrix4d(), new Matrix4d().translation(5, 0, 0).scale(-1, 1, 1)));
    assertThat(both.indices()).containsExactly(0, 1, 2, 3, 5, 4);
    assertThat(both.positions())
        .containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 4, 0, 0, 5, 1, 0);
    assertThat(both.texCoords()).hasSize(12).startsWith(0, 0, 1, 0).endsWith(1, 0, 0, 1);
    assertThat(both.bounds()).containsExactly(0, 0, 0, 5, 1, 0);
  }

  @Test
  void normalsStayUprightOnTheirSurfaceAndOfUnitLength() {
    Mesh tilted =
        MeshReplicator.of(triangle, List.of(new Matrix4d().scale(1, 1, 4).rotateX(Math.PI / 4)));
    assertThat(tilted.normals()[1]).isLessThan(-0.9f);
    assertThat(Math.hypot(tilted.normals()[1], tilted.normals()[2])).isBetween(0.9999, 1.0001);
    Mesh flat = MeshReplicator.of(triangle, List.of(new Matrix4d().scale(0)));
    assertThat(flat.normals()).startsWith(0, 0, 1);
  }

  @Test
  void copiesBeyondTheBoundAreLeftOut() {
    int vertices = 2_000_000;
    float[] positions = new float[3 * vertices];
    Mesh large =
        new Mesh(
            Mesh.Primitive.POINTS,
            positions,
            null,
            null,
            null,
            ONE,
            true,
            Mesh.boundsOf(positions, ONE));
    assertThat(MeshReplicator.most(large)).isEqualTo(2);
    assertThat(MeshReplicator.of(large, Collections.nCopies(1000, new Matrix4d())).indices())
        .hasSize(6);
  }
}
