package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * Joins an outline and its holes to one ring by bridge edges: the ring runs along a bridge to each
 * hole and back along the same line, as ear clipping needs it.
 */
final class PolygonHoleBridging {
  private final double[] xy;
  private List<Integer> ring = new ArrayList<>();
  private final List<List<Integer>> holes = new ArrayList<>();

  private PolygonHoleBridging(double[][] rings, double[] xy) {
    this.xy = xy;
    int first = 0;
    for (double[] points : rings) {
      List<Integer> indices = new ArrayList<>();
      for (int i = 0; i < points.length / 2; i++) {
        indices.add(first + i);
      }
      first += points.length / 2;
      holes.add(indices);
    }
    ring.addAll(holes.remove(0));
  }

  /** Returns the point indices of the joined ring, which touches itself along the bridges. */
  static int[] join(double[][] rings, double[] xy) {
    PolygonHoleBridging bridges = new PolygonHoleBridging(rings, xy);
    bridges.holes.sort(Comparator.comparingDouble(hole -> -bridges.right(hole)));
    for (int i = 0; i < bridges.holes.size(); i++) {
      bridges.cross(bridges.holes.get(i), bridges.holes.subList(i, bridges.holes.size()));
    }
    return bridges.ring.stream().mapToInt(Integer::intValue).toArray();
  }

  private double right(List<Integer> hole) {
    return hole.stream().mapToDouble(p -> xy[2 * p]).max().orElse(0);
  }

  /** Joins a hole by its shortest bridge that crosses no edge. */
  private void cross(List<Integer> hole, List<List<Integer>> others) {
    int bestRing = -1;
    int bestHole = -1;
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i < ring.size(); i++) {
      for (int j = 0; j < hole.size(); j++) {
        double length = square(xy, ring.get(i), hole.get(j));
        if (length < best && free(i, hole.get(j), others)) {
          best = length;
          bestRing = i;
          bestHole = j;
        }
      }
    }
    if (bestRing < 0) {
      throw new IllegalArgumentException("a hole lies outside its outline");
    }
    List<Integer> joined = new ArrayList<>(ring.subList(0, bestRing + 1));
    for (int k = 0; k <= hole.size(); k++) {
      joined.add(hole.get((bestHole + k) % hole.size()));
    }
    joined.addAll(ring.subList(bestRing, ring.size()));
    ring = joined;
  }

  private boolean free(int at, int to, List<List<Integer>> others) {
    int from = ring.get(at);
    int before = ring.get((at + ring.size() - 1) % ring.size());
    int after = ring.get((at + 1) % ring.size());
    boolean convex = TriangleMath.turn(xy, before, from, after) > 0;
    boolean left = TriangleMath.turn(xy, before, from, to) > 0;
    boolean right = TriangleMath.turn(xy, from, after, to) > 0;
    // The bridge must leave the corner towards the inside of the polygon.
    if (convex ? !(left && right) : !(left || right)) {
      return false;
    }
    if (meets(from, to, ring)) {
      return false;
    }
    return others.stream().noneMatch(hole -> meets(from, to, hole));
  }

  private boolean meets(int a, int b, List<Integer> loop) {
    for (int i = 0; i < loop.size(); i++) {
      int c = loop.get(i);
      int d = loop.get((i + 1) % loop.size());
      boolean apart = c != a && c != b && d != a && d != b;
      if (apart
          && TriangleMath.turn(xy, a, b, c) * TriangleMath.turn(xy, a, b, d) <= 0
          && TriangleMath.turn(xy, c, d, a) * TriangleMath.turn(xy, c, d, b) <= 0) {
        return true;
      }
    }
    return false;
  }

  /** Returns the squared distance of two points, x, y each. */
  static double square(double[] xy, int a, int b) {
    double x = xy[2 * b] - xy[2 * a];
    double y = xy[2 * b + 1] - xy[2 * a + 1];
    return x * x + y * y;
  }
}
