package org.selectiverenderer.x3d.tessellate;

import org.jspecify.annotations.Nullable;

/** Generates normals for nodes that specify none (X3D 4.0, 11.2.3 and 13.2.2). */
final class NormalGenerator {
  /** From this crease angle on every edge is smooth, except between opposite faces. */
  private static final double ALL_SMOOTH = 3.1;

  private NormalGenerator() {}

  /**
   * Returns the normals of all corners.
   *
   * @param xyz the points
   * @param corners point per corner, three per triangle of non-zero area
   * @param faces face per triangle, each below {@code faceCount}
   * @param creaseAngle radians; 0 gives each face its own normal
   */
  static VertexAttribute of(
      float[] xyz, int[] corners, int[] faces, int faceCount, double creaseAngle) {
    float[] faceNormals = FaceNormals.of(xyz, corners, faces, faceCount);
    if (!(creaseAngle > 0)) {
      return perFace(faceNormals, corners.length, faces);
    }
    float[] angles = CornerAngles.of(xyz, corners);
    if (creaseAngle >= ALL_SMOOTH) {
      float[] smooth = smooth(xyz.length / 3, corners, faces, faceNormals, angles);
      if (smooth != null) {
        return new VertexAttribute(smooth, 3, null);
      }
    }
    return new CreaseAngleNormals(xyz.length / 3, corners, faces, faceNormals, angles, creaseAngle)
        .attribute();
  }

  /** Returns normals in which each corner has its face's normal. */
  static VertexAttribute perFace(float[] faceNormals, int cornerCount, int[] faces) {
    int[] ids = new int[cornerCount];
    for (int corner = 0; corner < cornerCount; corner++) {
      ids[corner] = faces[corner / 3];
    }
    return new VertexAttribute(faceNormals, 3, ids);
  }

  /**
   * Returns one normal per point, the angle-weighted sum of its faces' normals; null if they cancel
   * out at some point, as they do where a file gives each face once per side.
   */
  private static float @Nullable [] smooth(
      int pointCount, int[] corners, int[] faces, float[] faceNormals, float[] angles) {
    float[] sums = new float[3 * pointCount];
    for (int i = 0, t = 0; i < corners.length; t++) {
      int f = 3 * faces[t];
      float x = faceNormals[f];
      float y = faceNormals[f + 1];
      float z = faceNormals[f + 2];
      for (int end = i + 3; i < end; i++) {
        int p = 3 * corners[i];
        float weight = angles[i];
        sums[p] += weight * x;
        sums[p + 1] += weight * y;
        sums[p + 2] += weight * z;
      }
    }
    boolean[] done = new boolean[pointCount];
    for (int corner = 0; corner < corners.length; corner++) {
      int point = corners[corner];
      if (!done[point]) {
        done[point] = true;
        int p = 3 * point;
        float length =
            (float)
                Math.sqrt(
                    sums[p] * sums[p] + sums[p + 1] * sums[p + 1] + sums[p + 2] * sums[p + 2]);
        if (!(length > 1e-3f * angles[corner]) || length < 1e-6f) {
          return null;
        }
        sums[p] /= length;
        sums[p + 1] /= length;
        sums[p + 2] /= length;
      }
    }
    return sums;
  }
}
