package org.selectiverenderer.models.simplify;

/**
 * Computes the distance of a point from a triangle: the distance from its plane where the
 * barycentric coordinates of the projected point are inside, else that from the nearest edge.
 */
final class PointTriangleDistance {
  private PointTriangleDistance() {}

  /** Returns the squared distance. */
  static double square(float[] v, int[] indices, int triangle, double x, double y, double z) {
    int a = MergedMesh.STRIDE * indices[3 * triangle];
    int b = MergedMesh.STRIDE * indices[3 * triangle + 1];
    int c = MergedMesh.STRIDE * indices[3 * triangle + 2];
    double ux = v[b] - v[a];
    double uy = v[b + 1] - v[a + 1];
    double uz = v[b + 2] - v[a + 2];
    double wx = v[c] - v[a];
    double wy = v[c + 1] - v[a + 1];
    double wz = v[c + 2] - v[a + 2];
    double px = x - v[a];
    double py = y - v[a + 1];
    double pz = z - v[a + 2];
    double uu = ux * ux + uy * uy + uz * uz;
    double uw = ux * wx + uy * wy + uz * wz;
    double ww = wx * wx + wy * wy + wz * wz;
    double up = ux * px + uy * py + uz * pz;
    double wp = wx * px + wy * py + wz * pz;
    double determinant = uu * ww - uw * uw;
    double s = ww * up - uw * wp;
    double t = uu * wp - uw * up;
    if (determinant > 0 && s >= 0 && t >= 0 && s + t <= determinant) {
      s /= determinant;
      t /= determinant;
      return length(px - s * ux - t * wx, py - s * uy - t * wy, pz - s * uz - t * wz);
    }
    double onU = toSegment(px, py, pz, ux, uy, uz);
    double onW = toSegment(px, py, pz, wx, wy, wz);
    double onThird = toSegment(px - ux, py - uy, pz - uz, wx - ux, wy - uy, wz - uz);
    return Math.min(onU, Math.min(onW, onThird));
  }

  /** Returns the squared distance of p from the segment between the origin and d. */
  private static double toSegment(
      double px, double py, double pz, double dx, double dy, double dz) {
    double square = length(dx, dy, dz);
    double along = square > 0 ? (px * dx + py * dy + pz * dz) / square : 0;
    double s = Math.max(0, Math.min(1, along));
    return length(px - s * dx, py - s * dy, pz - s * dz);
  }

  private static double length(double x, double y, double z) {
    return x * x + y * y + z * z;
  }
}
