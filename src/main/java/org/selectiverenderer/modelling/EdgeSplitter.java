package org.selectiverenderer.modelling;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/** Splits a mesh's edges, the longest first. */
final class EdgeSplitter {
  private static final int[] NONE = {};

  private record Edge(double square, int low, int high) {
    static final Comparator<Edge> LONGEST_FIRST =
        Comparator.comparingDouble((Edge e) -> -e.square)
            .thenComparingInt(Edge::low)
            .thenComparingInt(Edge::high);

    long key() {
      return MeshMeasures.edge(low, high);
    }
  }

  private float[] positions;
  private int[] triangles;
  private int points;
  private int count;
  private final Map<Long, int[]> beside = new HashMap<>();
  private final PriorityQueue<Edge> inside = new PriorityQueue<>(Edge.LONGEST_FIRST);
  private final PriorityQueue<Edge> border = new PriorityQueue<>(Edge.LONGEST_FIRST);

  EdgeSplitter(TriangleMesh mesh) {
    positions = mesh.positions().clone();
    triangles = mesh.triangles().clone();
    points = mesh.pointCount();
    count = mesh.triangleCount();
    for (int t = 0; t < count; t++) {
      for (int k = 0; k < 3; k++) {
        add(triangles[3 * t + k], triangles[3 * t + (k + 1) % 3], t);
      }
    }
    for (long key : beside.keySet()) {
      queue((int) (key >>> 32), (int) key);
    }
  }

  /** The squared length of the longest edge whose split adds at most so many triangles. */
  Optional<Double> longest(int most) {
    return Optional.ofNullable(next(most)).map(Edge::square);
  }

  /** Splits that edge and returns by how many triangles there are more. */
  int split(int most) {
    Edge edge = next(most);
    if (edge == null) {
      throw new IllegalStateException("there is no edge to split");
    }
    (beside.get(edge.key()).length == 1 ? border : inside).remove();
    int middle = middle(edge.low, edge.high);
    int[] around = beside.remove(edge.key());
    for (int triangle : around) {
      cut(triangle, edge, middle);
    }
    queue(edge.low, middle);
    queue(edge.high, middle);
    return around.length;
  }

  TriangleMesh mesh() {
    return new TriangleMesh(
        Arrays.copyOf(positions, 3 * points), Arrays.copyOf(triangles, 3 * count));
  }

  private @Nullable Edge next(int most) {
    Edge a = most < 2 ? null : inside.peek();
    Edge b = border.peek();
    if (a == null || b == null) {
      return a == null ? b : a;
    }
    return Edge.LONGEST_FIRST.compare(a, b) <= 0 ? a : b;
  }

  private void cut(int triangle, Edge edge, int middle) {
    int from = 3 * triangle;
    int place = 0;
    while (triangles[from + place] == edge.low || triangles[from + place] == edge.high) {
      place++;
    }
    int tip = triangles[from + place];
    int a = triangles[from + (place + 1) % 3];
    int b = triangles[from + (place + 2) % 3];
    triangles[from + (place + 2) % 3] = middle;
    if (3 * count + 3 > triangles.length) {
      triangles = Arrays.copyOf(triangles, 2 * triangles.length);
    }
    int added = count++;
    triangles[3 * added] = middle;
    triangles[3 * added + 1] = b;
    triangles[3 * added + 2] = tip;
    int[] shared = beside.get(key(b, tip));
    for (int i = 0; i < shared.length; i++) {
      shared[i] = shared[i] == triangle ? added : shared[i];
    }
    add(a, middle, triangle);
    add(middle, b, added);
    add(tip, middle, triangle);
    add(tip, middle, added);
    queue(tip, middle);
  }

  private int middle(int a, int b) {
    if (3 * points + 3 > positions.length) {
      positions = Arrays.copyOf(positions, 2 * positions.length);
    }
    for (int k = 0; k < 3; k++) {
      positions[3 * points + k] =
          (float) (((double) positions[3 * a + k] + positions[3 * b + k]) / 2);
    }
    return points++;
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
    if (sides <= 2) {
      Edge edge = new Edge(point(a).distanceSquared(point(b)), Math.min(a, b), Math.max(a, b));
      (sides == 1 ? border : inside).add(edge);
    }
  }

  private Vector3d point(int i) {
    return new Vector3d(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
  }

  private static long key(int a, int b) {
    return MeshMeasures.edge(Math.min(a, b), Math.max(a, b));
  }
}
