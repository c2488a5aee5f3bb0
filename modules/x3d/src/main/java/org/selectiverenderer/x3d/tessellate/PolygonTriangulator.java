package org.selectiverenderer.x3d.tessellate;

import earcut4j.Earcut;
import java.util.List;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * Triangulates polygons in space: convex ones as a fan, others by ear clipping after projection to
 * the coordinate plane of their largest projected area. Large self-intersecting ones also become
 * fans, as clipping them would take too long. Convexity is computed, since files with {@code
 * convex} TRUE and concave faces are common.
 */
final class PolygonTriangulator {
  /** Faces up to this number of points are always clipped. */
  private static final int FEW = 256;

  /** The budget per node, in squared points, for clipping larger self-intersecting faces. */
  private static final long WORK = 1 << 22;

  private final float[] xyz;
  private final TriangleListBuilder triangles;
  private long work = WORK;
  private int crossing;

  /**
   * Creates a splitter for the faces of a node.
   *
   * @param xyz the points that the list's stream refers to
   * @param triangles receives the triangles, wound as their polygons are
   */
  PolygonTriangulator(float[] xyz, TriangleListBuilder triangles) {
    this.xyz = xyz;
    this.triangles = triangles;
  }

  /** Adds the polygon of the stream positions {@code from} up to {@code to}, at least three. */
  void split(int from, int to, int face) {
    if (to - from == 3) {
      triangles.add(from, from + 1, from + 2, face);
      return;
    }
    double[] normal = new double[3];
    TriangleMath.newell(xyz, triangles.stream(), from, to, normal);
    if (convex(from, to, normal) || !clip(from, to, normal, face)) {
      for (int i = from + 1; i + 1 < to; i++) {
        triangles.add(from, i, i + 1, face);
      }
    }
  }

  /** Reports the faces that were not clipped, after all faces have been split. */
  void report(TessellationContext job) {
    if (crossing > 0) {
      job.problem(
          "has %s of more than %s points that intersect themselves; they are filled roughly"
              .formatted(crossing == 1 ? "a face" : crossing + " faces", FEW));
    }
  }

  /** Returns whether clipping exceeds the budget; it takes quadratic time where edges cross. */
  private boolean tooMuchWork(double[] plane) {
    long count = plane.length / 2;
    if (count <= FEW || !new PolygonSelfIntersection(plane).mayCrossItself()) {
      return false;
    }
    work -= count * count;
    return work < 0;
  }

  private double coordinate(int position, int axis) {
    return xyz[3 * triangles.point(position) + axis];
  }

  /** Returns whether the polygon is convex: it turns the same way at all corners, or not at all. */
  private boolean convex(int from, int to, double[] normal) {
    double largest = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    double tolerance = -1e-6 * largest;
    for (int i = from; i < to; i++) {
      int j = i + 1 == to ? from : i + 1;
      int k = j + 1 == to ? from : j + 1;
      double turn =
          TriangleMath.triple(
              normal,
              coordinate(j, 0) - coordinate(i, 0),
              coordinate(j, 1) - coordinate(i, 1),
              coordinate(j, 2) - coordinate(i, 2),
              coordinate(k, 0) - coordinate(j, 0),
              coordinate(k, 1) - coordinate(j, 1),
              coordinate(k, 2) - coordinate(j, 2));
      if (turn < tolerance) {
        return false;
      }
    }
    return true;
  }

  /** Clips ears in the coordinate plane of the largest projection; false if no ear is found. */
  private boolean clip(int from, int to, double[] normal, int face) {
    int up = 0;
    for (int axis = 1; axis < 3; axis++) {
      if (Math.abs(normal[axis]) > Math.abs(normal[up])) {
        up = axis;
      }
    }
    int first = (up + 1) % 3;
    int second = (up + 2) % 3;
    double[] plane = new double[2 * (to - from)];
    for (int i = from; i < to; i++) {
      plane[2 * (i - from)] = coordinate(i, first);
      plane[2 * (i - from) + 1] = coordinate(i, second);
    }
    if (tooMuchWork(plane)) {
      crossing++;
      return false;
    }
    List<Integer> ears = Earcut.earcut(plane, null, 2);
    double area = 0;
    for (int i = 0; i + 2 < ears.size(); i += 3) {
      area += TriangleMath.turn(plane, ears.get(i), ears.get(i + 1), ears.get(i + 2));
    }
    // earcut4j always winds its triangles in the same direction
    boolean turned = area * normal[up] < 0;
    for (int i = 0; i + 2 < ears.size(); i += 3) {
      int b = from + ears.get(turned ? i + 2 : i + 1);
      int c = from + ears.get(turned ? i + 1 : i + 2);
      triangles.add(from + ears.get(i), b, c, face);
    }
    return !ears.isEmpty();
  }
}
