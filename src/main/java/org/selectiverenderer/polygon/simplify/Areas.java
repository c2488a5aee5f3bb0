package org.selectiverenderer.polygon.simplify;

import java.util.Arrays;

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
    double ux = (double) vertices[b] - vertices[a];
    double uy = (double) vertices[b + 1] - vertices[a + 1];
    double uz = (double) vertices[b + 2] - vertices[a + 2];
    double vx = (double) vertices[c] - vertices[a];
    double vy = (double) vertices[c + 1] - vertices[a + 1];
    double vz = (double) vertices[c + 2] - vertices[a + 2];
    double nx = uy * vz - uz * vy;
    double ny = uz * vx - ux * vz;
    double nz = ux * vy - uy * vx;
    double sides = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz;
    double square = nx * nx + ny * ny + nz * nz;
    double scale = square > 1e-12 * sides * sides ? 1 / Math.sqrt(square) : 0;
    normal[0] = scale * nx;
    normal[1] = scale * ny;
    normal[2] = scale * nz;
  }

  static double area(float[] vertices, int[] indices, int triangle) {
    int a = JoinedMesh.STRIDE * indices[3 * triangle];
    int b = JoinedMesh.STRIDE * indices[3 * triangle + 1];
    int c = JoinedMesh.STRIDE * indices[3 * triangle + 2];
    double ux = (double) vertices[b] - vertices[a];
    double uy = (double) vertices[b + 1] - vertices[a + 1];
    double uz = (double) vertices[b + 2] - vertices[a + 2];
    double vx = (double) vertices[c] - vertices[a];
    double vy = (double) vertices[c + 1] - vertices[a + 1];
    double vz = (double) vertices[c + 2] - vertices[a + 2];
    double nx = uy * vz - uz * vy;
    double ny = uz * vx - ux * vz;
    double nz = ux * vy - uy * vx;
    return Math.sqrt(nx * nx + ny * ny + nz * nz) / 2;
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
