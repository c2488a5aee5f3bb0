package org.selectiverenderer.geometry.mesh;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;

/**
 * Refines a triangle mesh by longest-edge bisection, without changing its shape: the longest edge
 * is repeatedly split at its midpoint together with its adjacent triangles. An inner edge adds two
 * triangles, a border edge one. There are no T-junctions, and seams are kept. Deterministic.
 */
public final class LongestEdgeBisection {
  private static final int[] NONE = {};

  /** The vertices of the mesh; along a seam several vertices have the same position. */
  public interface Vertices {
    /** Returns the point of a vertex: the index of one representative vertex at its position. */
    int point(int vertex);

    /** Returns the squared distance between two points. */
    double square(int a, int b);

    /**
     * Creates the vertex at the midpoint of two others.
     *
     * @param point the point of the new vertex, or -1 if it is the first vertex there
     * @return its index
     */
    int middle(int a, int b, int point);
  }

  private record Edge(double square, int low, int high) {
    static final Comparator<Edge> LONGEST_FIRST =
        Comparator.comparingDouble((Edge edge) -> -edge.square)
            .thenComparingInt(Edge::low)
            .thenComparingInt(Edge::high);
  }

  private final Vertices vertices;
  private int[] indices;
  private int triangles;
  private final Map<Long, int[]> beside = new HashMap<>();
  private final PriorityQueue<Edge> inside = new PriorityQueue<>(Edge.LONGEST_FIRST);
  private final PriorityQueue<Edge> border = new PriorityQueue<>(Edge.LONGEST_FIRST);

  /**
   * Creates a splitter for a mesh.
   *
   * @param indices three vertices per triangle
   */
  public LongestEdgeBisection(Vertices vertices, int[] indices) {
    this.vertices = vertices;
    this.indices = indices.clone();
    triangles = indices.length / 3;
    for (int i = 0; i < indices.length; i++) {
      add(point(i), point(i % 3 == 2 ? i - 2 : i + 1), i / 3);
    }
    for (long key : beside.keySet()) {
      queue(EdgeKey.from(key), EdgeKey.to(key));
    }
  }

  /** Returns the current number of triangles. */
  public int triangles() {
    return triangles;
  }

  /** Returns the current triangles, three vertices each. */
  public int[] indices() {
    return Arrays.copyOf(indices, 3 * triangles);
  }

  /** Returns the squared length of the edge that {@link #split} would split; -1 if none. */
  public double longest(int most) {
    Edge edge = next(most);
    return edge == null ? -1 : edge.square;
  }

  /**
   * Splits the longest edge whose split adds at most {@code most} triangles.
   *
   * @return the number of triangles added; 0 if there is no such edge
   */
  public int split(int most) {
    Edge edge = next(most);
    if (edge == null) {
      return 0;
    }
    int[] around = beside.remove(key(edge.low, edge.high));
    (around.length == 1 ? border : inside).remove();
    Map<Long, Integer> middles = new HashMap<>();
    int middle = -1;
    for (int triangle : around) {
      middle = cut(triangle, edge, middles, middle);
    }
    queue(edge.low, middle);
    queue(edge.high, middle);
    return around.length;
  }

  private @Nullable Edge next(int most) {
    Edge a = most < 2 ? null : inside.peek();
    Edge b = border.peek();
    if (a == null || b == null) {
      return a == null ? b : a;
    }
    return Edge.LONGEST_FIRST.compare(a, b) <= 0 ? a : b;
  }

  private int point(int corner) {
    return vertices.point(indices[corner]);
  }

  /**
   * Splits a triangle at an edge.
   *
   * @param middle the point at the edge's midpoint, or -1 before it has been created
   * @return that point
   */
  private int cut(int triangle, Edge edge, Map<Long, Integer> middles, int middle) {
    int from = 3 * triangle;
    int place = 0;
    while (point(from + place) == edge.low || point(from + place) == edge.high) {
      place++;
    }
    int tip = indices[from + place];
    int a = indices[from + (place + 1) % 3];
    int b = indices[from + (place + 2) % 3];
    int m = middles.computeIfAbsent(key(a, b), made -> vertices.middle(a, b, middle));
    indices[from + (place + 2) % 3] = m;
    if (3 * triangles + 3 > indices.length) {
      indices = Arrays.copyOf(indices, 2 * indices.length + 3);
    }
    int added = triangles++;
    indices[3 * added] = m;
    indices[3 * added + 1] = b;
    indices[3 * added + 2] = tip;
    int atTip = vertices.point(tip);
    int atA = vertices.point(a);
    int atB = vertices.point(b);
    int atM = vertices.point(m);
    int[] shared = beside.get(key(atB, atTip));
    for (int i = 0; i < shared.length; i++) {
      shared[i] = shared[i] == triangle ? added : shared[i];
    }
    add(atA, atM, triangle);
    add(atM, atB, added);
    add(atTip, atM, triangle);
    add(atTip, atM, added);
    queue(atTip, atM);
    return atM;
  }

  private void add(int a, int b, int triangle) {
    int[] known = beside.getOrDefault(key(a, b), NONE);
    int[] more = Arrays.copyOf(known, known.length + 1);
    more[known.length] = triangle;
    beside.put(key(a, b), more);
  }

  /** Queues an edge for splitting; non-manifold edges of more than two triangles are not split. */
  private void queue(int a, int b) {
    int sides = beside.get(key(a, b)).length;
    if (sides <= 2 && a != b) {
      Edge edge = new Edge(vertices.square(a, b), Math.min(a, b), Math.max(a, b));
      (sides == 1 ? border : inside).add(edge);
    }
  }

  private static long key(int a, int b) {
    return EdgeKey.of(Math.min(a, b), Math.max(a, b));
  }
}
