package org.selectiverenderer.polygon.simplify;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;

/**
 * Adds polygons without changing a form, for a count that is to be met: the longest edge is split
 * in its middle with the triangles on both of its sides, again and again. An edge within a surface
 * adds two polygons, one on a border adds one. Normals, colours and texture coordinates of a new
 * vertex are the means of its neighbours', and seams stay seams.
 */
final class EdgeSplits {
  private static final int[] NONE = {};

  private record Edge(double square, int low, int high) {
    static final Comparator<Edge> LONGEST_FIRST =
        Comparator.comparingDouble((Edge edge) -> -edge.square)
            .thenComparingInt(Edge::low)
            .thenComparingInt(Edge::high);
  }

  private final double scale;
  private float[] vertices;
  private int[] origins;
  private int[] points;
  private int vertexCount;
  private int[] indices;
  private int triangleCount;
  private final Map<Long, int[]> beside = new HashMap<>();
  private final PriorityQueue<Edge> inside = new PriorityQueue<>(Edge.LONGEST_FIRST);
  private final PriorityQueue<Edge> border = new PriorityQueue<>(Edge.LONGEST_FIRST);

  private EdgeSplits(JoinedMesh mesh, double scale) {
    this.scale = scale;
    vertices = mesh.vertices().clone();
    origins = mesh.origins().clone();
    points = Seams.first(mesh, false);
    vertexCount = mesh.vertexCount();
    indices = mesh.indices().clone();
    triangleCount = mesh.polygons();
    for (int i = 0; i < indices.length; i++) {
      add(points[indices[i]], points[indices[i % 3 == 2 ? i - 2 : i + 1]], i / 3);
    }
    for (long key : beside.keySet()) {
      queue((int) (key >>> 32), (int) key);
    }
  }

  /**
   * The same form with so many polygons; with one less where the surface is closed and the number
   * of those missing is odd.
   *
   * @param scale of the grid that positions are rounded to
   */
  static JoinedMesh upTo(int polygons, JoinedMesh mesh, double scale) {
    EdgeSplits splits = new EdgeSplits(mesh, scale);
    while (splits.triangleCount < polygons && splits.split(polygons - splits.triangleCount)) {
      // Each adds one or two.
    }
    return splits.mesh();
  }

  /** The same form with so many more positions, each with one or two more polygons. */
  static JoinedMesh withMore(int positions, JoinedMesh mesh, double scale) {
    EdgeSplits splits = new EdgeSplits(mesh, scale);
    int added = 0;
    while (added < positions && splits.split(2)) {
      added++;
    }
    return splits.mesh();
  }

  private JoinedMesh mesh() {
    return new JoinedMesh(
        Arrays.copyOf(vertices, JoinedMesh.STRIDE * vertexCount),
        Arrays.copyOf(indices, 3 * triangleCount),
        Arrays.copyOf(origins, vertexCount));
  }

  private boolean split(int most) {
    Edge edge = next(most);
    if (edge == null) {
      return false;
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
    return true;
  }

  private @Nullable Edge next(int most) {
    Edge a = most < 2 ? null : inside.peek();
    Edge b = border.peek();
    if (a == null || b == null) {
      return a == null ? b : a;
    }
    return Edge.LONGEST_FIRST.compare(a, b) <= 0 ? a : b;
  }

  /**
   * @param middle the point in the middle of the edge, or -1 before it has been made
   * @return that point
   */
  private int cut(int triangle, Edge edge, Map<Long, Integer> middles, int middle) {
    int from = 3 * triangle;
    int place = 0;
    while (points[indices[from + place]] == edge.low
        || points[indices[from + place]] == edge.high) {
      place++;
    }
    int tip = indices[from + place];
    int a = indices[from + (place + 1) % 3];
    int b = indices[from + (place + 2) % 3];
    Long pair = key(Math.min(a, b), Math.max(a, b));
    Integer known = middles.get(pair);
    int m = known == null ? middle(a, b, middle) : known;
    middles.put(pair, m);
    indices[from + (place + 2) % 3] = m;
    if (3 * triangleCount + 3 > indices.length) {
      indices = Arrays.copyOf(indices, 2 * indices.length + 3);
    }
    int added = triangleCount++;
    indices[3 * added] = m;
    indices[3 * added + 1] = b;
    indices[3 * added + 2] = tip;
    int[] shared = beside.get(edgeKey(points[b], points[tip]));
    for (int i = 0; i < shared.length; i++) {
      shared[i] = shared[i] == triangle ? added : shared[i];
    }
    add(points[a], points[m], triangle);
    add(points[m], points[b], added);
    add(points[tip], points[m], triangle);
    add(points[tip], points[m], added);
    queue(points[tip], points[m]);
    return points[m];
  }

  private int middle(int a, int b, int point) {
    if (vertexCount == origins.length) {
      int larger = 2 * vertexCount + 1;
      vertices = Arrays.copyOf(vertices, JoinedMesh.STRIDE * larger);
      origins = Arrays.copyOf(origins, larger);
      points = Arrays.copyOf(points, larger);
    }
    int to = JoinedMesh.STRIDE * vertexCount;
    for (int i = 0; i < JoinedMesh.STRIDE; i++) {
      double mean =
          ((double) vertices[JoinedMesh.STRIDE * a + i] + vertices[JoinedMesh.STRIDE * b + i]) / 2;
      vertices[to + i] = (float) (i < 3 ? Math.rint(mean * scale) / scale : mean) + 0.0f;
    }
    vertices[to + JoinedMesh.PART] = vertices[JoinedMesh.STRIDE * a + JoinedMesh.PART];
    origins[vertexCount] = origins[a];
    points[vertexCount] = point < 0 ? vertexCount : point;
    return vertexCount++;
  }

  private void add(int a, int b, int triangle) {
    int[] known = beside.getOrDefault(edgeKey(a, b), NONE);
    int[] more = Arrays.copyOf(known, known.length + 1);
    more[known.length] = triangle;
    beside.put(edgeKey(a, b), more);
  }

  /** Edges of more than two triangles are left alone: they are no surface's. */
  private void queue(int a, int b) {
    int sides = beside.get(edgeKey(a, b)).length;
    if (sides <= 2 && a != b) {
      double square = 0;
      for (int axis = 0; axis < 3; axis++) {
        double side =
            (double) vertices[JoinedMesh.STRIDE * a + axis]
                - vertices[JoinedMesh.STRIDE * b + axis];
        square += side * side;
      }
      (sides == 1 ? border : inside).add(new Edge(square, Math.min(a, b), Math.max(a, b)));
    }
  }

  private static long edgeKey(int a, int b) {
    return key(Math.min(a, b), Math.max(a, b));
  }

  private static long key(int low, int high) {
    return (long) low << 32 | high;
  }
}
