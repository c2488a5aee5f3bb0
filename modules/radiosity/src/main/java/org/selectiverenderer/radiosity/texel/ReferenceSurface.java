package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/**
 * The surface of an object's reference version, with a search for the closest point. Immutable; for
 * several threads.
 */
final class ReferenceSurface {
  /** Cosine of the largest angle between normals that are alike. */
  private static final double ALIKE = 0.5;

  /** Largest distance of the closest point, as a share of the object's extent. */
  private static final double NEAR = 0.05;

  /**
   * Distance that a turned normal counts as, as a share of the object's extent: light changes with
   * the normal as it does with the position, and of two sheets the one that faces the same side is
   * to be found.
   */
  private static final double TURNED = 0.015;

  private final SceneTriangles triangles;
  private final float[] boxes;
  private final int[] first;
  private final int[] count;
  private final int[] ids;
  private final float[] normals;
  private final double limit;
  private final double turned;

  /**
   * @param members the triangles of the reference version, ascending
   */
  ReferenceSurface(SceneTriangles triangles, int[] members) {
    this.triangles = triangles;
    Bvh tree = triangles.tree(members);
    boxes = tree.boxes();
    first = tree.first();
    count = tree.count();
    ids = new int[members.length];
    normals = new float[3 * members.length];
    double[] normal = new double[3];
    for (int i = 0; i < ids.length; i++) {
      ids[i] = members[tree.order()[i]];
      triangles.normal(ids[i], normal);
      for (int axis = 0; axis < 3; axis++) {
        normals[3 * i + axis] = (float) normal[axis];
      }
    }
    double extent = 0;
    for (int axis = 0; axis < 3 && ids.length > 0; axis++) {
      extent = Math.max(extent, (double) boxes[axis + 3] - boxes[axis]);
    }
    limit = NEAR * extent;
    turned = 2 * TURNED * TURNED * extent * extent;
  }

  /** A closest-point search; one per thread. */
  final class Search {
    private final int[] stack = new int[Bvh.MAX_DEPTH];
    private final ClosestPointOnTriangle place = new ClosestPointOnTriangle(triangles.corners());
    private int item = -1;
    private int triangle;
    private double u;
    private double v;
    private double best;

    /** Returns the triangle found last. */
    int triangle() {
      return triangle;
    }

    /** Returns the barycentric weight of its second corner. */
    double u() {
      return u;
    }

    /** Returns the barycentric weight of its third corner. */
    double v() {
      return v;
    }

    /**
     * Finds the closest point on the surface with a like normal; deviation of the normal counts as
     * distance. Of equally close points that of the first triangle is found.
     *
     * @param normal a unit normal, or the zero vector to accept every normal
     * @return false if no point is near enough
     */
    boolean find(double[] point, double[] normal) {
      best = limit * limit;
      triangle = Integer.MAX_VALUE;
      if (ids.length == 0) {
        return false;
      }
      // The triangle closest to the last point is near the next one, too, so that most of the tree
      // is culled.
      if (item >= 0) {
        test(item, point, normal);
      }
      int size = 1;
      stack[0] = 0;
      while (size > 0) {
        int node = stack[--size];
        if (away(node, point) > best) {
          continue;
        }
        if (count[node] > 0) {
          for (int i = first[node]; i < first[node] + count[node]; i++) {
            test(i, point, normal);
          }
          continue;
        }
        int near = first[node];
        boolean left = away(near, point) <= away(near + 1, point);
        stack[size++] = left ? near + 1 : near;
        stack[size++] = left ? near : near + 1;
      }
      return triangle != Integer.MAX_VALUE;
    }

    private void test(int i, double[] point, double[] normal) {
      double facing =
          normals[3 * i] * normal[0]
              + normals[3 * i + 1] * normal[1]
              + normals[3 * i + 2] * normal[2];
      boolean any = normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
      if ((triangles.twoSided()[ids[i]] ? Math.abs(facing) : facing) <= ALIKE && !any) {
        return;
      }
      double distance = place.nearest(ids[i], point) + (any ? 0 : (1 - facing) * turned);
      if (distance < best || distance == best && ids[i] < triangle) {
        best = distance;
        item = i;
        triangle = ids[i];
        u = place.u();
        v = place.v();
      }
    }

    /** Returns the squared distance from a point to a node's box. */
    private double away(int node, double[] point) {
      double sum = 0;
      for (int axis = 0; axis < 3; axis++) {
        double low = boxes[6 * node + axis] - point[axis];
        double high = point[axis] - boxes[6 * node + 3 + axis];
        double d = low > 0 ? low : high > 0 ? high : 0;
        sum += d * d;
      }
      return sum;
    }
  }
}
