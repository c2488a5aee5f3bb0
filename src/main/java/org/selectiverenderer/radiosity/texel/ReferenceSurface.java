package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.geometry.tree.BoxTree;
import org.selectiverenderer.geometry.tree.BoxTreeBuilder;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/** The surface of the version that stands for an object. Immutable; for several threads. */
final class ReferenceSurface {
  /** Cosine of the angle between normals that are alike. */
  private static final double ALIKE = 0.5;

  /** How far places may be apart, as a share of the object's extent. */
  private static final double NEAR = 0.05;

  /**
   * What a turned normal counts as distance, as a share of the object's extent: light changes with
   * the normal as it does from place to place, and of two sheets it is that of the one that faces
   * the same side.
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
   * @param members triangles of the reference version, ascending
   */
  ReferenceSurface(SceneTriangles triangles, int[] members) {
    this.triangles = triangles;
    float[] corners = triangles.corners();
    BoxTree tree =
        BoxTreeBuilder.build(
            members.length,
            (item, box) -> {
              int at = 9 * members[item];
              for (int axis = 0; axis < 3; axis++) {
                float a = corners[at + axis];
                float b = corners[at + 3 + axis];
                float c = corners[at + 6 + axis];
                box[axis] = Math.min(a, Math.min(b, c));
                box[axis + 3] = Math.max(a, Math.max(b, c));
              }
            });
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

  /** A search; one per thread. */
  final class Search {
    private final int[] stack = new int[BoxTree.MAX_DEPTH];
    private final TrianglePlace place = new TrianglePlace(triangles.corners());
    private int item = -1;
    private int triangle;
    private double u;
    private double v;
    private double best;

    /** The triangle found last. */
    int triangle() {
      return triangle;
    }

    /** Weight of its second corner. */
    double u() {
      return u;
    }

    /** Weight of its third corner. */
    double v() {
      return v;
    }

    /**
     * Looks for the place nearest to a point where the normal is alike, and the nearer the more it
     * is; of several equally near ones that of the first triangle.
     *
     * @param normal of length 1, or 0 where every normal is alike
     * @return false if there is none near
     */
    boolean find(double[] point, double[] normal) {
      best = limit * limit;
      triangle = Integer.MAX_VALUE;
      if (ids.length == 0) {
        return false;
      }
      // What was nearest to one point is near to the next: most of the tree need not be entered.
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

    /** The square of a point's distance to a node's box. */
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
