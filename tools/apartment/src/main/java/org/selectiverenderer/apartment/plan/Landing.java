package org.selectiverenderer.apartment.plan;

import java.util.OptionalDouble;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** Finds the height at which a thing that is let down comes to rest. */
final class Landing {
  /** Points so near to a thing's lowest one are what it stands on. */
  private static final double SOLE = 0.002;

  private Landing() {}

  /**
   * The highest point of the support below any point of the thing's sole.
   *
   * @param thing at its place in x and z, at any height
   * @param support where it is
   * @param from no part of the support above this height counts
   * @return empty if there is nothing below it
   */
  static OptionalDouble height(TriangleMesh thing, TriangleMesh support, double from) {
    Bounds b = thing.bounds();
    double highest = Double.NEGATIVE_INFINITY;
    int[] t = support.triangles();
    float[] p = support.positions();
    for (int i = 0; i < t.length; i += 3) {
      int a = 3 * t[i];
      int c = 3 * t[i + 1];
      int e = 3 * t[i + 2];
      boolean beside =
          Math.max(p[a], Math.max(p[c], p[e])) < b.minX()
              || Math.min(p[a], Math.min(p[c], p[e])) > b.maxX()
              || Math.max(p[a + 2], Math.max(p[c + 2], p[e + 2])) < b.minZ()
              || Math.min(p[a + 2], Math.min(p[c + 2], p[e + 2])) > b.maxZ();
      double area = TriangleMath.turn(p[a], p[a + 2], p[c], p[c + 2], p[e], p[e + 2]);
      // Seen from above, z runs down the page, so what faces up goes clockwise.
      if (!beside && area < -1e-10) {
        highest = Math.max(highest, touch(thing, b.minY() + SOLE, p, a, c, e, area, from));
      }
    }
    return highest > Double.NEGATIVE_INFINITY ? OptionalDouble.of(highest) : OptionalDouble.empty();
  }

  private static double touch(
      TriangleMesh thing, double sole, float[] p, int a, int c, int e, double area, double from) {
    double highest = Double.NEGATIVE_INFINITY;
    float[] q = thing.positions();
    for (int i = 0; i < q.length; i += 3) {
      if (q[i + 1] <= sole) {
        double u = TriangleMath.turn(q[i], q[i + 2], p[c], p[c + 2], p[e], p[e + 2]) / area;
        double v = TriangleMath.turn(p[a], p[a + 2], q[i], q[i + 2], p[e], p[e + 2]) / area;
        if (u >= 0 && v >= 0 && u + v <= 1) {
          double y = u * p[a + 1] + v * p[c + 1] + (1 - u - v) * p[e + 1];
          highest = y <= from ? Math.max(highest, y) : highest;
        }
      }
    }
    return highest;
  }
}
