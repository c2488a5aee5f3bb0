package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import java.util.Comparator;
import org.selectiverenderer.geometry.TriangleMath;

/** Tests whether a 2D polygon intersects itself, by a plane sweep over its edges. */
final class PolygonSelfIntersection {
  /** The maximum number of edge pairs compared, which ordinary polygons do not reach. */
  private static final int PAIRS = 20_000_000;

  /** The maximum number of edge pairs per point, for very large polygons. */
  private static final int PAIRS_PER_POINT = 200;

  private final double[] plane;
  private final int count;

  /** The sweep axis, along which the edges are shorter relative to the polygon's extent. */
  private final int axis;

  /**
   * Prepares the test of a polygon.
   *
   * @param plane x, y per point
   */
  PolygonSelfIntersection(double[] plane) {
    this.plane = plane;
    count = plane.length / 2;
    axis = relativeLength(0) <= relativeLength(1) ? 0 : 1;
  }

  private double relativeLength(int along) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    double sum = 0;
    for (int i = 0; i < count; i++) {
      double here = plane[2 * i + along];
      least = Math.min(least, here);
      most = Math.max(most, here);
      sum += Math.abs(plane[2 * next(i) + along] - here);
    }
    return sum / (most - least);
  }

  private int next(int point) {
    return point + 1 == count ? 0 : point + 1;
  }

  private double low(int edge, int along) {
    return Math.min(plane[2 * edge + along], plane[2 * next(edge) + along]);
  }

  private double high(int edge, int along) {
    return Math.max(plane[2 * edge + along], plane[2 * next(edge) + along]);
  }

  /**
   * Returns whether two edges properly cross; touching does not count. Also true if the test would
   * take too many comparisons.
   */
  boolean mayCrossItself() {
    Integer[] order = new Integer[count];
    Arrays.setAll(order, i -> i);
    Arrays.sort(order, Comparator.comparingDouble(edge -> low(edge, axis)));
    long pairs = Math.max(PAIRS, (long) PAIRS_PER_POINT * count);
    for (int i = 0; i < count; i++) {
      double end = high(order[i], axis);
      for (int j = i + 1; j < count && low(order[j], axis) <= end; j++) {
        if (--pairs < 0 || cross(order[i], order[j])) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean cross(int a, int b) {
    int across = 1 - axis;
    return high(a, across) >= low(b, across)
        && high(b, across) >= low(a, across)
        && side(a, b) * side(a, next(b)) < 0
        && side(b, a) * side(b, next(a)) < 0;
  }

  /** Returns the side of an edge's line on which a point is: -1, 0 or 1. */
  private double side(int edge, int point) {
    return Math.signum(TriangleMath.turn(plane, edge, next(edge), point));
  }
}
