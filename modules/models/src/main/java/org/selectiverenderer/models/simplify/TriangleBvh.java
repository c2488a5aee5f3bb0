package org.selectiverenderer.models.simplify;

/**
 * A bounding volume hierarchy (BVH) of the triangles of a surface for nearest-triangle queries:
 * boxes are split at the middle of the longest side. Immutable and thread-safe.
 */
final class TriangleBvh {
  private static final int LEAF = 4;
  private static final int DEEPEST = 64;

  /** Relative tolerance of a squared distance, far above its rounding error. */
  private static final double ROUNDING = 1e-6;

  /** Absolute tolerance, as a share of the squared extent of the surface. */
  private static final double CANCELLING = 1e-9;

  private final float[] v;
  private final int[] indices;
  private final int[] order;

  // Each node has a box, and either the triangles order[from..to) or, if to is negative, the
  // children from and -to.
  private float[] boxes;
  private int[] from;
  private int[] to;
  private int nodes;
  private final double room;

  TriangleBvh(MergedMesh mesh) {
    v = mesh.vertices();
    indices = mesh.indices();
    order = new int[mesh.polygons()];
    float[] centres = new float[3 * order.length];
    for (int t = 0; t < order.length; t++) {
      order[t] = t;
      for (int axis = 0; axis < 3; axis++) {
        centres[3 * t + axis] =
            (at(indices[3 * t], axis) + at(indices[3 * t + 1], axis) + at(indices[3 * t + 2], axis))
                / 3;
      }
    }
    int most = Math.max(1, 2 * order.length);
    boxes = new float[6 * most];
    from = new int[most];
    to = new int[most];
    build(0, order.length, centres, 0);
    double square = 0;
    for (int axis = 0; axis < 3 && order.length > 0; axis++) {
      square += Math.pow((double) boxes[3 + axis] - boxes[axis], 2);
    }
    room = CANCELLING * square;
  }

  private float at(int vertex, int axis) {
    return v[MergedMesh.STRIDE * vertex + axis];
  }

  private int build(int first, int end, float[] centres, int depth) {
    int node = nodes++;
    bound(node, first, end);
    int axis = longest(centres, first, end);
    int middle = end - first <= LEAF || depth == DEEPEST ? first : split(first, end, axis, centres);
    if (middle == first || middle == end) {
      from[node] = first;
      to[node] = end;
    } else {
      int left = build(first, middle, centres, depth + 1);
      from[node] = left;
      to[node] = -build(middle, end, centres, depth + 1);
    }
    return node;
  }

  private void bound(int node, int first, int end) {
    for (int axis = 0; axis < 3; axis++) {
      float least = Float.POSITIVE_INFINITY;
      float most = Float.NEGATIVE_INFINITY;
      for (int i = first; i < end; i++) {
        for (int corner = 3 * order[i]; corner < 3 * order[i] + 3; corner++) {
          least = Math.min(least, at(indices[corner], axis));
          most = Math.max(most, at(indices[corner], axis));
        }
      }
      boxes[6 * node + axis] = least;
      boxes[6 * node + 3 + axis] = most;
    }
  }

  private int longest(float[] centres, int first, int end) {
    int longest = 0;
    float length = -1;
    for (int axis = 0; axis < 3; axis++) {
      float side = -range(centres, first, end, axis, -1) - range(centres, first, end, axis, 1);
      if (side > length) {
        length = side;
        longest = axis;
      }
    }
    return longest;
  }

  /** Returns the least value of the centres along an axis; with sign -1, minus the greatest. */
  private float range(float[] centres, int first, int end, int axis, int sign) {
    float least = Float.POSITIVE_INFINITY;
    for (int i = first; i < end; i++) {
      least = Math.min(least, sign * centres[3 * order[i] + axis]);
    }
    return least;
  }

  private int split(int first, int end, int axis, float[] centres) {
    float middle = (range(centres, first, end, axis, 1) - range(centres, first, end, axis, -1)) / 2;
    int low = first;
    for (int i = first; i < end; i++) {
      if (centres[3 * order[i] + axis] < middle) {
        int swapped = order[i];
        order[i] = order[low];
        order[low++] = swapped;
      }
    }
    return low;
  }

  /**
   * Finds the triangle nearest to a point.
   *
   * @param near a triangle that is likely to be near, or -1: it prunes the search and does not
   *     change the result
   * @param nearest receives the squared distance
   * @return the index of the triangle
   */
  int nearest(double x, double y, double z, int near, double[] nearest) {
    int[] open = new int[DEEPEST + 8];
    double[] away = new double[DEEPEST + 8];
    int count = 0;
    open[count] = 0;
    away[count++] = toBox(0, x, y, z);
    double best = within(x, y, z, near);
    int found = -1;
    while (count > 0) {
      int node = open[--count];
      if (away[count] >= best) {
        continue;
      }
      if (to[node] < 0) {
        int left = from[node];
        int right = -to[node];
        double toLeft = toBox(left, x, y, z);
        double toRight = toBox(right, x, y, z);
        boolean leftFirst = toLeft <= toRight;
        open[count] = leftFirst ? right : left;
        away[count++] = leftFirst ? toRight : toLeft;
        open[count] = leftFirst ? left : right;
        away[count++] = leftFirst ? toLeft : toRight;
        continue;
      }
      for (int i = from[node]; i < to[node]; i++) {
        double distance = PointTriangleDistance.square(v, indices, order[i], x, y, z);
        if (distance < best || distance == best && order[i] < found) {
          best = distance;
          found = order[i];
        }
      }
    }
    nearest[0] = best;
    return found;
  }

  /**
   * Returns an upper bound of the squared distance to the surface, with a tolerance for rounding.
   */
  private double within(double x, double y, double z, int near) {
    double distance = near < 0 ? Double.NaN : square(near, x, y, z);
    return distance >= 0
        ? Math.max(Math.nextUp(distance), distance * (1 + ROUNDING) + room)
        : Double.POSITIVE_INFINITY;
  }

  /** Returns the squared distance of a point from a triangle. */
  double square(int triangle, double x, double y, double z) {
    return PointTriangleDistance.square(v, indices, triangle, x, y, z);
  }

  private double toBox(int node, double x, double y, double z) {
    double dx = outside(boxes[6 * node], boxes[6 * node + 3], x);
    double dy = outside(boxes[6 * node + 1], boxes[6 * node + 4], y);
    double dz = outside(boxes[6 * node + 2], boxes[6 * node + 5], z);
    return dx * dx + dy * dy + dz * dz;
  }

  private static double outside(double least, double most, double value) {
    return Math.max(0, Math.max(least - value, value - most));
  }
}
