package org.selectiverenderer.radiosity.mesh;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * A conforming triangle mesh over the facets of several bodies: where facets share an edge, all of
 * them are divided there, so that there are no T-junctions. Corners at the same position are one
 * point.
 *
 * <p>A facet is refined by longest-edge bisection: the edge that is halved is the end of the path
 * over neighbours with ever longer longest edges (Rivara 1997), which bounds the smallest angle.
 */
final class ConformingTriangleMesh {
  /** An edge between two points, the smaller number first. */
  record Edge(int a, int b) {
    static Edge of(int a, int b) {
      return a < b ? new Edge(a, b) : new Edge(b, a);
    }
  }

  /** A facet of the mesh with its points. */
  static final class Tile {
    final int body;
    final Facet facet;
    final int[] points;
    final int number;

    /** The number of the facet, as it was added, that this one is a part of. */
    final int root;

    /** The unit normal, and twice the area. */
    final double[] plane;

    Tile(int body, Facet facet, int[] points, int number, int root) {
      this.body = body;
      this.facet = facet;
      this.points = points;
      this.number = number;
      this.root = root;
      this.plane = plane(facet.corners());
    }

    private static double[] plane(float[] c) {
      double[] plane = new double[4];
      TriangleMath.cross(
          c[3] - c[0], c[4] - c[1], c[5] - c[2], c[6] - c[0], c[7] - c[1], c[8] - c[2], plane);
      plane[3] = TriangleMath.normalize(plane);
      return plane;
    }

    /** Returns whether another facet's plane has nearly the same normal. */
    boolean alike(double[] other) {
      return plane[0] * other[0] + plane[1] * other[1] + plane[2] * other[2] > 0.999;
    }

    Edge edge(int i) {
      return Edge.of(points[i], points[(i + 1) % 3]);
    }
  }

  /**
   * Least height of a facet over an edge that is divided, as a share of the scene's extent: lower
   * ones would become lines.
   */
  private static final double HEIGHT = 2.5e-5;

  /**
   * Facets with less area than this are degenerate and do not count; a share of the extent's
   * square.
   */
  private static final double FLAT = 3e-10;

  private final double height;
  private final double flat;

  private final Map<Long, Integer> pointOf = new HashMap<>();
  private final List<float[]> places = new ArrayList<>();
  private final List<Double> values = new ArrayList<>();
  private final Map<Edge, List<Tile>> byEdge = new HashMap<>();
  private final TreeSet<Tile> tiles = new TreeSet<>((a, b) -> Integer.compare(a.number, b.number));
  private int numbers;
  private int count;

  /**
   * @param extent largest extent of the scene, metres
   */
  ConformingTriangleMesh(double extent) {
    this(HEIGHT * extent, FLAT * extent * extent);
  }

  private ConformingTriangleMesh(double height, double flat) {
    this.height = height;
    this.flat = flat;
  }

  /** Returns a mesh of the same scene without facets. */
  ConformingTriangleMesh empty() {
    return new ConformingTriangleMesh(height, flat);
  }

  /** Adds a facet of a body. */
  Tile add(int body, Facet facet) {
    return add(body, facet, numbers);
  }

  private Tile add(int body, Facet facet, int root) {
    int[] points = new int[3];
    for (int i = 0; i < 3; i++) {
      int at = 3 * i;
      points[i] = point(facet.corners(), at);
    }
    Tile tile = new Tile(body, facet, points, numbers++, root);
    tiles.add(tile);
    count += flat(tile) ? 0 : 1;
    for (int i = 0; i < 3; i++) {
      byEdge.computeIfAbsent(tile.edge(i), key -> new ArrayList<>(2)).add(tile);
    }
    return tile;
  }

  private int point(float[] corners, int at) {
    return pointOf.computeIfAbsent(
        RadiosityMesh.place(corners, at),
        key -> {
          places.add(new float[] {corners[at], corners[at + 1], corners[at + 2]});
          values.add(0.0);
          return places.size() - 1;
        });
  }

  /** Returns whether a facet is degenerate: so thin that a file would show no area. */
  boolean flat(Tile tile) {
    return tile.plane[3] < flat;
  }

  /** Returns the number of facets that are not degenerate, as a browser draws them. */
  int count() {
    return count;
  }

  Iterable<Tile> tiles() {
    return tiles;
  }

  boolean alive(Tile tile) {
    return tiles.contains(tile);
  }

  int pointCount() {
    return places.size();
  }

  float[] place(int point) {
    return places.get(point);
  }

  /** Returns the light at a point, as a share of display white. */
  double value(int point) {
    return values.get(point);
  }

  void value(int point, double value) {
    values.set(point, value);
  }

  double length(Edge edge) {
    float[] a = places.get(edge.a());
    float[] b = places.get(edge.b());
    double x = a[0] - b[0];
    double y = a[1] - b[1];
    double z = a[2] - b[2];
    return Math.sqrt(x * x + y * y + z * z);
  }

  Edge longest(Tile tile) {
    Edge best = tile.edge(0);
    for (int i = 1; i < 3; i++) {
      Edge edge = tile.edge(i);
      if (longer(edge, best)) {
        best = edge;
      }
    }
    return best;
  }

  /** A strict total order, so that the longest-edge path ends. */
  private boolean longer(Edge edge, Edge other) {
    int order = Double.compare(length(edge), length(other));
    if (order == 0) {
      order = Integer.compare(edge.a(), other.a());
    }
    return order == 0 ? edge.b() > other.b() : order > 0;
  }

  /**
   * Returns the terminal edge of a facet's longest-edge path, which has to be halved before the
   * facet can be halved at its own longest edge.
   */
  Edge terminal(Tile tile) {
    Edge edge = longest(tile);
    boolean moved = true;
    while (moved) {
      moved = false;
      for (Tile next : byEdge.get(edge)) {
        Edge its = longest(next);
        if (longer(its, edge)) {
          edge = its;
          moved = true;
          break;
        }
      }
    }
    return edge;
  }

  /** Returns whether all facets at an edge are high enough over it to be divided there. */
  boolean sound(Edge edge) {
    double least = height * length(edge);
    for (Tile tile : byEdge.get(edge)) {
      if (tile.plane[3] < least) {
        return false;
      }
    }
    return true;
  }

  /** Returns the number of facets that dividing an edge adds. */
  int cost(Edge edge) {
    return byEdge.get(edge).size();
  }

  /** Returns the longest edge whose division adds exactly this number of facets. */
  Optional<Edge> longestOfCost(int cost) {
    Edge best = null;
    for (Map.Entry<Edge, List<Tile>> entry : byEdge.entrySet()) {
      boolean fits = entry.getValue().size() == cost && sound(entry.getKey());
      if (fits && (best == null || longer(entry.getKey(), best))) {
        best = entry.getKey();
      }
    }
    return Optional.ofNullable(best);
  }

  List<Edge> edges() {
    return new ArrayList<>(byEdge.keySet());
  }

  /** Returns the facets at an edge. */
  List<Tile> at(Edge edge) {
    return byEdge.getOrDefault(edge, List.of());
  }

  /** Divides an edge at its midpoint; returns the new facets. */
  List<Tile> halve(Edge edge) {
    float[] a = places.get(edge.a());
    float[] b = places.get(edge.b());
    return divide(
        edge, new float[] {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}, 0.5f);
  }

  /**
   * Divides an edge at a point on it.
   *
   * @param share position of the point on the edge, 0 at its first point to 1 at its second
   * @return the new facets
   */
  List<Tile> divide(Edge edge, float[] place, float share) {
    List<Tile> made = new ArrayList<>(4);
    double value = values.get(edge.a()) * (1 - share) + values.get(edge.b()) * share;
    int before = places.size();
    for (Tile tile : List.copyOf(byEdge.get(edge))) {
      remove(tile);
      int i = 0;
      while (!tile.edge(i).equals(edge)) {
        i++;
      }
      int j = (i + 1) % 3;
      float along = tile.points[i] == edge.a() ? share : 1 - share;
      made.add(add(tile.body, part(tile.facet, j, i, j, along, place), tile.root));
      made.add(add(tile.body, part(tile.facet, i, i, j, along, place), tile.root));
    }
    for (int point = before; point < places.size(); point++) {
      values.set(point, value);
    }
    return made;
  }

  private void remove(Tile tile) {
    tiles.remove(tile);
    count -= flat(tile) ? 0 : 1;
    for (int i = 0; i < 3; i++) {
      Edge edge = tile.edge(i);
      List<Tile> at = byEdge.get(edge);
      at.remove(tile);
      if (at.isEmpty()) {
        byEdge.remove(edge);
      }
    }
  }

  /** Returns the facet with one corner moved to a point between its corners i and j. */
  private static Facet part(Facet facet, int moved, int i, int j, float share, float[] place) {
    float[] corners = facet.corners().clone();
    float[] local = facet.local().clone();
    float[] normals = facet.normals().clone();
    double length = 0;
    float[] normal = new float[3];
    for (int axis = 0; axis < 3; axis++) {
      corners[3 * moved + axis] = place[axis];
      local[3 * moved + axis] =
          (1 - share) * facet.local()[3 * i + axis] + share * facet.local()[3 * j + axis];
      normal[axis] =
          (1 - share) * facet.normals()[3 * i + axis] + share * facet.normals()[3 * j + axis];
      length += normal[axis] * normal[axis];
    }
    double scale = length > 0 ? 1 / Math.sqrt(length) : 0;
    for (int axis = 0; axis < 3; axis++) {
      normals[3 * moved + axis] = (float) (normal[axis] * scale);
    }
    return new Facet(facet.source(), corners, local, normals);
  }
}
