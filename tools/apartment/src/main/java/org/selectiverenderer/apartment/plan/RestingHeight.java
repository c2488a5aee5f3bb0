package org.selectiverenderer.apartment.plan;

import java.util.OptionalDouble;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** Computes the height at which an object comes to rest when it is lowered onto a support. */
final class RestingHeight {
  /** Height above an object's lowest point up to which points belong to its sole, metres. */
  private static final double SOLE = 0.002;

  private RestingHeight() {}

  /**
   * Returns the height of the highest point of the support below any point of the object's sole.
   *
   * @param thing the object at its position in x and z, at any height
   * @param support the supporting mesh at its position
   * @param from height above which the support is ignored, metres
   * @return empty if no part of the support lies below the object
   */
  static OptionalDouble height(TriangleMesh thing, TriangleMesh support, double from) {
    BoundingBox b = thing.bounds();
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
      // Projected from above, z runs down the page, so triangles that face up are clockwise.
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
