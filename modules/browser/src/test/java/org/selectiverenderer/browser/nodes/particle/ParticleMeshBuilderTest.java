package org.selectiverenderer.browser.nodes.particle;

import static org.assertj.core.api.Assertions.assertThat;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.TestNodes;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;

class ParticleMeshBuilderTest {
  private static final Vector3d RIGHT = new Vector3d(1, 0, 0);
  private static final Vector3d UP = new Vector3d(0, 1, 0);

  private final Node system = new TestNodes().node("ParticleSystem", "geometryType", "GEOMETRY");

  private static ParticlePool particles(int count) {
    ParticlePool particles = new ParticlePool(count);
    for (int i = 0; i < count; i++) {
      particles.add(new Vector3d(i, 0, 0), new Vector3d(), 0, 1);
    }
    return particles;
  }

  /** Lines that go to and fro between two vertices. */
  private static Mesh lines(int indices) {
    int[] ends = new int[indices];
    for (int i = 0; i < indices; i++) {
      ends[i] = i % 2;
    }
    float[] positions = {0, 0, 0, 0, 1, 0};
    return new Mesh(
        Mesh.Primitive.LINES,
        positions,
        null,
        null,
        null,
        ends,
        false,
        Mesh.boundsOf(positions, ends));
  }

  @Test
  void aGeometryStandsAtEachParticle() {
    Mesh mesh = new ParticleMeshBuilder(system, particles(3), 0).make(RIGHT, UP, lines(4));
    assertThat(mesh.positions())
        .containsExactly(0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0);
    assertThat(mesh.indices()).containsExactly(0, 1, 0, 1, 2, 3, 2, 3, 4, 5, 4, 5);
  }

  @Test
  void aGeometryOfFewVerticesAndManyIndicesFillsNoMemory() {
    Mesh mesh =
        new ParticleMeshBuilder(system, particles(20_000), 0).make(RIGHT, UP, lines(1_000_000));
    assertThat(mesh.indices()).hasSize(6_000_000);
    assertThat(mesh.vertexCount()).isEqualTo(12);
  }
}
