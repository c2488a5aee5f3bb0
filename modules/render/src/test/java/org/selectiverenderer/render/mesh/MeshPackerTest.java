package org.selectiverenderer.render.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.mesh.Mesh;

class MeshPackerTest {
  /** A ball of rows * columns * 2 triangles, unit radius, wound outwards. */
  static Mesh ball(int rows, int columns) {
    float[] positions = new float[3 * (rows + 1) * columns];
    List<Integer> indices = new ArrayList<>();
    for (int row = 0; row <= rows; row++) {
      double polar = Math.PI * row / rows;
      for (int column = 0; column < columns; column++) {
        double around = 2 * Math.PI * column / columns;
        int at = 3 * (row * columns + column);
        positions[at] = (float) (Math.sin(polar) * Math.cos(around));
        positions[at + 1] = (float) Math.cos(polar);
        positions[at + 2] = (float) (-Math.sin(polar) * Math.sin(around));
        if (row < rows) {
          int next = (column + 1) % columns;
          int a = row * columns + column;
          int b = (row + 1) * columns + column;
          int c = (row + 1) * columns + next;
          int d = row * columns + next;
          Collections.addAll(indices, a, b, c, a, c, d);
        }
      }
    }
    return mesh(positions, indices.stream().mapToInt(Integer::intValue).toArray());
  }

  private static Mesh mesh(float[] positions, int[] indices) {
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        positions,
        positions,
        null,
        null,
        indices,
        true,
        Mesh.boundsOf(positions, indices));
  }

  /** The corners of each triangle as text, sorted: what is drawn, whatever the order. */
  private static List<String> triangles(PackedMesh packed) {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < packed.indexCount(); i += 3) {
      StringBuilder text = new StringBuilder();
      for (int corner = 0; corner < 3; corner++) {
        text.append(Arrays.toString(position(packed, i + corner)));
      }
      all.add(text.toString());
    }
    Collections.sort(all);
    return all;
  }

  private static float[] position(PackedMesh packed, int i) {
    ByteBuffer indices = packed.indices();
    int vertex =
        packed.wideIndices() ? indices.getInt(4 * i) : Short.toUnsignedInt(indices.getShort(2 * i));
    int at = vertex * packed.layout().stride();
    ByteBuffer vertices = packed.vertices();
    return new float[] {
      vertices.getFloat(at), vertices.getFloat(at + 4), vertices.getFloat(at + 8)
    };
  }

  @Test
  void packingKeepsEveryTriangleAndItsWinding() {
    Mesh ball = ball(20, 30);
    List<String> expected = new ArrayList<>();
    for (int i = 0; i < ball.indices().length; i += 3) {
      StringBuilder text = new StringBuilder();
      for (int corner = 0; corner < 3; corner++) {
        int v = 3 * ball.indices()[i + corner];
        text.append(Arrays.toString(Arrays.copyOfRange(ball.positions(), v, v + 3)));
      }
      expected.add(text.toString());
    }
    Collections.sort(expected);
    PackedMesh packed = MeshPacker.pack(ball);
    assertThat(triangles(packed)).isEqualTo(expected);
    assertThat(packed.clusters().size()).isGreaterThan(1);
  }

  @Test
  void verticesThatNoIndexUsesAreLeftOut() {
    Mesh mesh = mesh(new float[] {0, 0, 0, 9, 9, 9, 1, 0, 0, 0, 1, 0}, new int[] {0, 2, 3});
    PackedMesh packed = MeshPacker.pack(mesh);
    assertThat(packed.vertices().limit()).isEqualTo(3 * packed.layout().stride());
    assertThat(packed.indexBytes()).isEqualTo(2);
  }

  @Test
  void manyVerticesTakeWideIndices() {
    assertThat(MeshPacker.pack(ball(255, 256)).wideIndices()).isFalse();
    assertThat(MeshPacker.pack(ball(256, 256)).wideIndices()).isTrue();
  }

  @Test
  void normalsAndColoursSurviveWithinAStep() {
    float[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    float[] normals = {0.6f, 0, 0.8f, 0, -1, 0, 0, 0, 1};
    float[] colors = {0.5f, 0, 1, 1, 0, 0, 0, 0.25f, 1, 1, 1, 1};
    Mesh mesh =
        new Mesh(
            Mesh.Primitive.TRIANGLES,
            positions,
            normals,
            colors,
            null,
            new int[] {0, 1, 2},
            true,
            Mesh.boundsOf(positions, new int[] {0, 1, 2}));
    PackedMesh packed = MeshPacker.pack(mesh);
    int at = packed.layout().normal();
    assertThat(packed.vertices().getShort(at) / 32767.0).isCloseTo(0.6, within(1e-4));
    assertThat(packed.vertices().get(packed.layout().color()) & 0xff).isEqualTo(128);
    assertThat(MeshPacker.translucent(mesh)).isTrue();
  }

  @Test
  void aClusterFacesAwayOnlyIfEachOfItsTrianglesDoes() {
    PackedMesh packed = MeshPacker.pack(ball(80, 120));
    TriangleClusters clusters = packed.clusters();
    Random random = new Random(1);
    int culled = 0;
    for (int trial = 0; trial < 200; trial++) {
      double[] eye = random.doubles(3, -4, 4).toArray();
      for (int c = 0; c < clusters.size(); c++) {
        if (clusters.facesAway(c, eye[0], eye[1], eye[2])) {
          culled++;
          for (int i = clusters.firstIndex()[c]; i < clusters.firstIndex()[c + 1]; i += 3) {
            assertThat(front(packed, i, eye)).isLessThanOrEqualTo(1e-6);
          }
        }
      }
    }
    assertThat(culled).isGreaterThan(200 * clusters.size() / 4);
  }

  @Test
  void aClusterFacesTheEyeOnlyIfEachOfItsTrianglesDoes() {
    PackedMesh packed = MeshPacker.pack(ball(80, 120));
    TriangleClusters clusters = packed.clusters();
    Random random = new Random(2);
    int facing = 0;
    for (int trial = 0; trial < 200; trial++) {
      double[] eye = random.doubles(3, -8, 8).toArray();
      for (int c = 0; c < clusters.size(); c++) {
        if (clusters.facesTowards(c, eye[0], eye[1], eye[2])) {
          facing++;
          for (int i = clusters.firstIndex()[c]; i < clusters.firstIndex()[c + 1]; i += 3) {
            assertThat(front(packed, i, eye)).isGreaterThanOrEqualTo(-1e-6);
          }
        }
      }
    }
    assertThat(facing).isGreaterThan(200 * clusters.size() / 8);
  }

  /** Above 0 if the eye is on the front side of the triangle that begins at an index. */
  private static double front(PackedMesh packed, int i, double[] eye) {
    float[] a = position(packed, i);
    float[] b = position(packed, i + 1);
    float[] c = position(packed, i + 2);
    double[] u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    double[] v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    return (u[1] * v[2] - u[2] * v[1]) * (eye[0] - a[0])
        + (u[2] * v[0] - u[0] * v[2]) * (eye[1] - a[1])
        + (u[0] * v[1] - u[1] * v[0]) * (eye[2] - a[2]);
  }
}
