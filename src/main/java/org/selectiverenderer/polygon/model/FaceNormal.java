package org.selectiverenderer.polygon.model;

/** The normal of a triangle. */
final class FaceNormal {
  private FaceNormal() {}

  /**
   * The unit normal; NaN for a triangle without area.
   *
   * @param at the place of the triangle's first corner among the indices
   */
  static double[] of(float[] positions, int[] indices, int at) {
    int a = 3 * indices[at];
    int b = 3 * indices[at + 1];
    int c = 3 * indices[at + 2];
    double ux = (double) positions[b] - positions[a];
    double uy = (double) positions[b + 1] - positions[a + 1];
    double uz = (double) positions[b + 2] - positions[a + 2];
    double vx = (double) positions[c] - positions[a];
    double vy = (double) positions[c + 1] - positions[a + 1];
    double vz = (double) positions[c + 2] - positions[a + 2];
    double nx = uy * vz - uz * vy;
    double ny = uz * vx - ux * vz;
    double nz = ux * vy - uy * vx;
    double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    return new double[] {nx / length, ny / length, nz / length};
  }
}
