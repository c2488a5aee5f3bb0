package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.geometry.TriangleMath;

/** Computes one normal per face. */
final class FaceNormals {
  private FaceNormals() {}

  /**
   * Returns the unit normal of each face, the direction of the sum of its triangles' area vectors.
   * For a non-planar polygon it is the direction of the largest projected area (Newell's method).
   *
   * @param xyz the points
   * @param corners point per corner, three per triangle
   * @param faces face per triangle, each below {@code faceCount}
   * @return x, y, z per face; zeros for a face without triangles
   */
  static float[] of(float[] xyz, int[] corners, int[] faces, int faceCount) {
    double[] sums = new double[3 * faceCount];
    double[] normal = new double[3];
    for (int i = 0, t = 0; i < corners.length; i += 3, t++) {
      int a = 3 * corners[i];
      int b = 3 * corners[i + 1];
      int c = 3 * corners[i + 2];
      TriangleMath.normal(xyz, a, b, c, normal);
      int f = 3 * faces[t];
      sums[f] += normal[0];
      sums[f + 1] += normal[1];
      sums[f + 2] += normal[2];
    }
    float[] normals = new float[sums.length];
    for (int f = 0; f < sums.length; f += 3) {
      double x = sums[f];
      double y = sums[f + 1];
      double z = sums[f + 2];
      double square = x * x + y * y + z * z;
      if (square > 0) {
        double scale = 1 / Math.sqrt(square);
        normals[f] = (float) (x * scale);
        normals[f + 1] = (float) (y * scale);
        normals[f + 2] = (float) (z * scale);
      } else if (corners.length > 0) {
        // triangles that cancel out, as in a bow tie: any unit vector is acceptable
        normals[f + 1] = 1;
      }
    }
    return normals;
  }
}
