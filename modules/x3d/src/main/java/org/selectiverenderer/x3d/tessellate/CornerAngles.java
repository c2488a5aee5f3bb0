package org.selectiverenderer.x3d.tessellate;

/** Computes the interior angles of triangles, by which face normals are weighted. */
final class CornerAngles {
  private CornerAngles() {}

  /**
   * Returns the angle at each corner in radians, to about 1e-4, which is enough for a weight.
   *
   * @param xyz the points
   * @param corners point per corner, three per triangle of non-zero area
   */
  static float[] of(float[] xyz, int[] corners) {
    float[] angles = new float[corners.length];
    for (int i = 0; i < corners.length; i += 3) {
      int a = 3 * corners[i];
      int b = 3 * corners[i + 1];
      int c = 3 * corners[i + 2];
      double ux = (double) xyz[b] - xyz[a];
      double uy = (double) xyz[b + 1] - xyz[a + 1];
      double uz = (double) xyz[b + 2] - xyz[a + 2];
      double vx = (double) xyz[c] - xyz[b];
      double vy = (double) xyz[c + 1] - xyz[b + 1];
      double vz = (double) xyz[c + 2] - xyz[b + 2];
      double wx = (double) xyz[a] - xyz[c];
      double wy = (double) xyz[a + 1] - xyz[c + 1];
      double wz = (double) xyz[a + 2] - xyz[c + 2];
      double u = 1 / Math.sqrt(ux * ux + uy * uy + uz * uz);
      double v = 1 / Math.sqrt(vx * vx + vy * vy + vz * vz);
      double w = 1 / Math.sqrt(wx * wx + wy * wy + wz * wz);
      float atA = arcCosine(-(ux * wx + uy * wy + uz * wz) * u * w);
      float atB = arcCosine(-(ux * vx + uy * vy + uz * vz) * u * v);
      angles[i] = atA;
      angles[i + 1] = atB;
      float atC = (float) Math.PI - atA - atB;
      angles[i + 2] = atC < 0 ? 0 : atC;
    }
    return angles;
  }

  /** Approximates arccos with an error below 7e-5 (Abramowitz and Stegun, 1964, 4.4.45). */
  private static float arcCosine(double cosine) {
    double size = Math.abs(cosine);
    double x = size > 1 ? 1 : size; // faster than Math.min, which treats signed zeros
    double angle =
        Math.sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
    return (float) (cosine < 0 ? Math.PI - angle : angle);
  }
}
