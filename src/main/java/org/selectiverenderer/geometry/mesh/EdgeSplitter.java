package org.selectiverenderer.geometry.mesh;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;

/**
 * Adds triangles to a surface without changing its form: the longest edge is split in its middle
 * with the triangles on both of its sides, again and again. An edge within the surface adds two
 * triangles, one on a border adds one; there are no T-junctions, and seams stay seams.
 * Deterministic.
 */
public final class EdgeSplitter {
  private static final int[] NONE = {};

  /** The vertices that triangles refer to; several lie at one point where a seam runs. */
  public interface Vertices {
    /** The point that a vertex lies at: the number of one vertex there. */
    int point(int vertex);

    /** The square of the distance between two points. */
    double square(int a, int b);

    /**
     * Makes the vertex in the middle of two others.
     *
     * @param point that it lies at, or -1 when it is the first there
     * @return its number
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
   * @param indices three vertices per triangle
   */
  public EdgeSplitter(Vertices vertices, int[] indices) {
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

  /** How many triangles there are now. */
  public int triangles() {
    return triangles;
  }

  /** Three vertices per triangle. */
  public int[] indices() {
    return Arrays.copyOf(indices, 3 * triangles);
  }

  /** The squared length of the edge that would be split; negative when there is none. */
  public double longest(int most) {
    Edge edge = next(most);
    return edge == null ? -1 : edge.square;
  }

  /**
   * Splits the longest edge that adds at most so many triangles.
   *
   * @return by how many triangles there are more; 0 when there is no such edge
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
   * @param middle the point in the middle of the edge, or -1 before it has been made
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

  /** Edges of more than two triangles are left alone: they are no surface's. */
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
