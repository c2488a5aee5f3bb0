package org.selectiverenderer.polygon.simplify;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;

/** The planes and areas of triangles. */
final class Areas {
  private Areas() {}

  /**
   * The unit normal of a triangle; zeros when it has no area to speak of, that is when its height
   * is less than about 1e-6 of its longest side: a browser would leave it out, or rounding of the
   * coordinates in a file would make such a one of it.
   */
  static void normal(float[] vertices, int[] indices, int triangle, double[] normal) {
    int a = JoinedMesh.STRIDE * indices[3 * triangle];
    int b = JoinedMesh.STRIDE * indices[3 * triangle + 1];
    int c = JoinedMesh.STRIDE * indices[3 * triangle + 2];
    if (TriangleMath.hasArea(vertices, a, b, c, 1e-12)) {
      TriangleMath.normal(vertices, a, b, c, normal);
      TriangleMath.normalize(normal);
    } else {
      Arrays.fill(normal, 0);
    }
  }

  static double area(float[] vertices, int[] indices, int triangle) {
    int a = JoinedMesh.STRIDE * indices[3 * triangle];
    int b = JoinedMesh.STRIDE * indices[3 * triangle + 1];
    int c = JoinedMesh.STRIDE * indices[3 * triangle + 2];
    double[] normal = new double[3];
    TriangleMath.normal(vertices, a, b, c, normal);
    return TriangleMath.length(normal) / 2;
  }

  /** The mesh without triangles that have no area. */
  static JoinedMesh dropEmpty(JoinedMesh mesh) {
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
