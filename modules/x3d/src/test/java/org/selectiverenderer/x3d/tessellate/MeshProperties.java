package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Properties of meshes that have closed forms. */
final class MeshProperties {
  private MeshProperties() {}

  /** Enclosed volume by the divergence theorem; negative when the triangles face inwards. */
  static double volume(Mesh mesh) {
    double sum = 0;
    for (int i = 0; i < mesh.indices().length; i += 3) {
      double[] a = point(mesh, i);
      double[] n = cross(mesh, i);
      sum += a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
    }
    return sum / 6;
  }

  static double area(Mesh mesh) {
    double sum = 0;
    for (int i = 0; i < mesh.indices().length; i += 3) {
      sum += length(cross(mesh, i)) / 2;
    }
    return sum;
  }

  /** Vertices minus edges plus faces, points at equal positions counted once. */
  static int euler(Mesh mesh) {
    Set<String> points = new HashSet<>();
    Set<String> edges = new HashSet<>();
    for (int i = 0; i < mesh.indices().length; i++) {
      String a = Arrays.toString(point(mesh, i));
      String b = Arrays.toString(point(mesh, i % 3 == 2 ? i - 2 : i + 1));
      points.add(a);
      edges.add(a.compareTo(b) < 0 ? a + b : b + a);
    }
    return points.size() - edges.size() + mesh.polygons();
  }

  /** The normal of the vertex at a place of the index array. */
  static double[] normal(Mesh mesh, int place) {
    int v = 3 * mesh.indices()[place];
    float[] n = mesh.normals();
    return new double[] {n[v], n[v + 1], n[v + 2]};
  }

  static double[] point(Mesh mesh, int place) {
    int v = 3 * mesh.indices()[place];
    float[] p = mesh.positions();
    return new double[] {p[v] + 0.0, p[v + 1] + 0.0, p[v + 2] + 0.0};
  }

  /** The normal of the triangle whose indices begin at {@code i}, twice its area long. */
  static double[] cross(Mesh mesh, int i) {
    double[] a = point(mesh, i);
    double[] b = point(mesh, i + 1);
    double[] c = point(mesh, i + 2);
    double[] u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    double[] v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    return new double[] {
      u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
    };
  }

  static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static double length(double[] a) {
    return Math.sqrt(dot(a, a));
  }

  /** What holds of every mesh: see {@link Mesh}. */
  static void assertSound(Mesh mesh) {
    for (float value : mesh.positions()) {
      assertThat(value).isFinite();
    }
    for (int index : mesh.indices()) {
      assertThat(index).isBetween(0, mesh.vertexCount() - 1);
    }
    if (mesh.normals() != null) {
      assertThat(mesh.normals()).hasSize(mesh.positions().length);
      for (int i = 0; i < mesh.indices().length; i++) {
        assertThat(length(normal(mesh, i))).isBetween(0.9999, 1.0001);
      }
    }
    if (mesh.colors() != null) {
      assertThat(mesh.colors()).hasSize(mesh.vertexCount() * 4);
    }
    if (mesh.texCoords() != null) {
      assertThat(mesh.texCoords()).hasSize(mesh.vertexCount() * 2);
    }
    assertThat(
            mesh.indices().length
                % switch (mesh.primitive()) {
                  case TRIANGLES -> 3;
                  case LINES -> 2;
                  case POINTS -> 1;
                })
        .isZero();
  }

  /** Whether each vertex normal is on the outer side of its triangle. */
  static void assertNormalsAgreeWithWinding(Mesh mesh) {
    for (int i = 0; i < mesh.indices().length; i++) {
      assertThat(dot(normal(mesh, i), cross(mesh, i - i % 3))).isPositive();
    }
  }
}
