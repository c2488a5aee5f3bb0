package org.selectiverenderer.polygon.model;

import org.selectiverenderer.geometry.TriangleMath;

/** Computes the normal of a triangle. */
final class FaceNormal {
  private FaceNormal() {}

  /**
   * Returns the unit normal; NaN for a triangle without area.
   *
   * @param at position of the triangle's first corner in the indices
   */
  static double[] of(float[] positions, int[] indices, int at) {
    int a = 3 * indices[at];
    int b = 3 * indices[at + 1];
    int c = 3 * indices[at + 2];
    double[] normal = new double[3];
    TriangleMath.normal(positions, a, b, c, normal);
    double length = TriangleMath.length(normal);
    return new double[] {normal[0] / length, normal[1] / length, normal[2] / length};
  }
}
