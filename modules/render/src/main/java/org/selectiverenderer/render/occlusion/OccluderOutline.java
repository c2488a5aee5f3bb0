package org.selectiverenderer.render.occlusion;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * Builds the outline of coplanar triangles: the edges that occur an odd number of times. Vertices
 * of equal position are one corner whatever their indices, because OpenGL leaves no gap between
 * triangles whose corners agree to the bit.
 */
final class OccluderOutline {
  /** The largest sine of the angle between two edges that are joined into one. */
  private static final double STRAIGHT = 1e-9;

  private final float[] positions;
  private final Map<Place, Integer> numbers = new HashMap<>();
  private final List<double[]> places = new ArrayList<>();
  private final Set<Edge> edges = new LinkedHashSet<>();

  /**
   * @param positions x, y, z per vertex
   */
  OccluderOutline(float[] positions) {
    this.positions = positions;
  }

  /** A vertex position; minus zero is normalised to zero. */
  private record Place(float x, float y, float z) {
    // Written out, as records link theirs when first called: the first frame would wait for it.
    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Place one
          && Float.compare(x, one.x) == 0
          && Float.compare(y, one.y) == 0
          && Float.compare(z, one.z) == 0;
    }

    @Override
    public int hashCode() {
      return 31 * (31 * Float.hashCode(x) + Float.hashCode(y)) + Float.hashCode(z);
    }
  }

  private record Edge(int low, int high) {
    static Edge of(int a, int b) {
      return new Edge(Math.min(a, b), Math.max(a, b));
    }

    int other(int corner) {
      return corner == low ? high : low;
    }

    // Written out, as records link theirs when first called: the first frame would wait for it.
    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Edge one && low == one.low && high == one.high;
    }

    @Override
    public int hashCode() {
      return 31 * low + high;
    }
  }

  /** Adds an edge of a triangle, or removes it if it is there already. */
  void toggle(int vertex, int next) {
    toggle(Edge.of(number(vertex), number(next)));
  }

  private void toggle(Edge edge) {
    if (edge.low != edge.high && !edges.remove(edge)) {
      edges.add(edge);
    }
  }

  private int number(int vertex) {
    int i = 3 * vertex;
    Place place = new Place(positions[i] + 0f, positions[i + 1] + 0f, positions[i + 2] + 0f);
    Integer known = numbers.get(place);
    if (known != null) {
      return known;
    }
    numbers.put(place, places.size());
    places.add(new double[] {place.x, place.y, place.z});
    return places.size() - 1;
  }

  /** Returns the outline, with collinear edges joined. */
  OccluderPolygon patch(double[] plane, double thickness, double tilt, double area) {
    straighten();
    Map<Integer, Integer> used = new HashMap<>();
    List<double[]> corners = new ArrayList<>();
    int[] pairs = new int[2 * edges.size()];
    int at = 0;
    for (Edge edge : edges) {
      for (int corner : new int[] {edge.low, edge.high}) {
        if (used.putIfAbsent(corner, corners.size()) == null) {
          corners.add(places.get(corner));
        }
        pairs[at++] = used.get(corner);
      }
    }
    double[] points = new double[3 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      System.arraycopy(corners.get(i), 0, points, 3 * i, 3);
    }
    return new OccluderPolygon(points, pairs, plane, thickness, tilt, area, sphere(points));
  }

  /** Joins two collinear edges at a corner that has no other edges. */
  private void straighten() {
    Map<Integer, List<Edge>> at = new HashMap<>();
    for (Edge edge : edges) {
      at.computeIfAbsent(edge.low, corner -> new ArrayList<>(2)).add(edge);
      at.computeIfAbsent(edge.high, corner -> new ArrayList<>(2)).add(edge);
    }
    for (int corner = 0; corner < places.size(); corner++) {
      List<Edge> two = at.getOrDefault(corner, List.of());
      if (two.size() != 2) {
        continue;
      }
      Edge first = two.get(0);
      Edge second = two.get(1);
      int from = first.other(corner);
      int to = second.other(corner);
      Edge joined = Edge.of(from, to);
      if (from != to && !edges.contains(joined) && straight(from, corner, to)) {
        edges.remove(first);
        edges.remove(second);
        edges.add(joined);
        at.get(from).replaceAll(edge -> edge.equals(first) ? joined : edge);
        at.get(to).replaceAll(edge -> edge.equals(second) ? joined : edge);
      }
    }
  }

  private boolean straight(int from, int corner, int to) {
    double[] a = places.get(from);
    double[] b = places.get(corner);
    double[] c = places.get(to);
    double[] u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    double[] v = {c[0] - b[0], c[1] - b[1], c[2] - b[2]};
    double[] cross = new double[3];
    TriangleMath.cross(u[0], u[1], u[2], v[0], v[1], v[2], cross);
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2] > 0
        && TriangleMath.length(cross) <= STRAIGHT * TriangleMath.length(u) * TriangleMath.length(v);
  }

  private static double[] sphere(double[] points) {
    double[] sphere = new double[4];
    for (int i = 0; i < points.length; i++) {
      sphere[i % 3] += points[i] / (points.length / 3);
    }
    for (int i = 0; i < points.length; i += 3) {
      double x = points[i] - sphere[0];
      double y = points[i + 1] - sphere[1];
      double z = points[i + 2] - sphere[2];
      sphere[3] = Math.max(sphere[3], Math.sqrt(x * x + y * y + z * z));
    }
    return sphere;
  }
}
