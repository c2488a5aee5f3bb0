package org.selectiverenderer.apartment;

import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** Measures by sampling, with nothing of the layout's own code. */
final class ContactMeasurement {

  private ContactMeasurement() {}

  /**
   * The least height of the thing's lower end above the support's surface below it, metres;
   * negative when it is sunk in. Rays go down from the thing's lowest points.
   */
  static double gap(TriangleMesh thing, TriangleMesh support) {
    double lowest = thing.bounds().minY();
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < thing.pointCount(); i++) {
      float x = thing.positions()[3 * i];
      float y = thing.positions()[3 * i + 1];
      float z = thing.positions()[3 * i + 2];
      if (y < lowest + 0.002) {
        least = Math.min(least, nearest(x, lowest, z, support));
      }
    }
    return least;
  }

  /** From y to the surface nearest to it above or below the place. */
  private static double nearest(double x, double y, double z, TriangleMesh support) {
    double best = Double.POSITIVE_INFINITY;
    float[] p = support.positions();
    int[] t = support.triangles();
    for (int i = 0; i < t.length; i += 3) {
      int a = 3 * t[i];
      int b = 3 * t[i + 1];
      int c = 3 * t[i + 2];
      double det =
          (p[b] - p[a]) * (double) (p[c + 2] - p[a + 2])
              - (p[c] - p[a]) * (double) (p[b + 2] - p[a + 2]);
      double u = ((x - p[a]) * (p[c + 2] - p[a + 2]) - (p[c] - p[a]) * (z - p[a + 2])) / det;
      double v = ((p[b] - p[a]) * (z - p[a + 2]) - (x - p[a]) * (p[b + 2] - p[a + 2])) / det;
      if (u >= 0 && v >= 0 && u + v <= 1) {
        double height = p[a + 1] + u * (p[b + 1] - p[a + 1]) + v * (p[c + 1] - p[a + 1]);
        best = Math.abs(y - height) < Math.abs(best) ? y - height : best;
      }
    }
    return best;
  }
}
