package org.selectiverenderer.models.simplify;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;

/** Computes normals and areas of triangles. */
final class TriangleAreas {
  private TriangleAreas() {}

  /**
   * Computes the unit normal of a triangle; zeros when the triangle is degenerate: its height is
   * less than about 1e-6 of its longest side, so that a browser would not draw it, or rounding of
   * the coordinates in a file could make it empty.
   */
  static void normal(float[] vertices, int[] indices, int triangle, double[] normal) {
    int a = MergedMesh.STRIDE * indices[3 * triangle];
    int b = MergedMesh.STRIDE * indices[3 * triangle + 1];
    int c = MergedMesh.STRIDE * indices[3 * triangle + 2];
    if (TriangleMath.hasArea(vertices, a, b, c, 1e-12)) {
      TriangleMath.normal(vertices, a, b, c, normal);
      TriangleMath.normalize(normal);
    } else {
      Arrays.fill(normal, 0);
    }
  }

  static double area(float[] vertices, int[] indices, int triangle) {
    int a = MergedMesh.STRIDE * indices[3 * triangle];
    int b = MergedMesh.STRIDE * indices[3 * triangle + 1];
    int c = MergedMesh.STRIDE * indices[3 * triangle + 2];
    double[] normal = new double[3];
    TriangleMath.normal(vertices, a, b, c, normal);
    return TriangleMath.length(normal) / 2;
  }

  /** Returns the mesh without degenerate triangles. */
  static MergedMesh dropEmpty(MergedMesh mesh) {
    double[] normal = new double[3];
    int[] kept = new int[mesh.indices().length];
    int count = 0;
    for (int t = 0; t < mesh.polygons(); t++) {
      normal(mesh.vertices(), mesh.indices(), t, normal);
      if (normal[0] != 0 || normal[1] != 0 || normal[2] != 0) {
        System.arraycopy(mesh.indices(), 3 * t, kept, count, 3);
        count += 3;
      }
    }
    return count == kept.length ? mesh : mesh.with(mesh.vertices(), Arrays.copyOf(kept, count));
  }
}
