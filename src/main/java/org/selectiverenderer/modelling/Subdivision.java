package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.joml.Vector3d;

/**
 * Loop subdivision (Loop, 1987, with Warren's weights): every triangle becomes four, and the
 * surface becomes smooth. A border stays a border and becomes a smooth line. Meshes whose faces do
 * not share points should be welded before.
 */
public final class Subdivision {
  private final TriangleMesh mesh;
  private final MeshBuilder out = new MeshBuilder();
  private final Map<Long, Integer> middles = new HashMap<>();
  private final Map<Long, int[]> opposites = new HashMap<>();
  private final List<Set<Integer>> neighbours = new ArrayList<>();
  private final List<Set<Integer>> alongBorder = new ArrayList<>();

  private Subdivision(TriangleMesh mesh) {
    this.mesh = mesh;
    for (int i = 0; i < mesh.pointCount(); i++) {
      neighbours.add(new LinkedHashSet<>());
      alongBorder.add(new LinkedHashSet<>());
    }
    int[] t = mesh.triangles();
    for (int i = 0; i < t.length; i++) {
      int from = t[i];
      int to = t[i % 3 == 2 ? i - 2 : i + 1];
      int opposite = t[i % 3 == 0 ? i + 2 : i - 1];
      opposites.computeIfAbsent(undirected(from, to), k -> new int[] {-1, -1})[from < to ? 0 : 1] =
          opposite;
      neighbours.get(from).add(to);
      neighbours.get(to).add(from);
    }
    for (int[] edge : MeshMeasures.border(mesh)) {
      alongBorder.get(edge[0]).add(edge[1]);
      alongBorder.get(edge[1]).add(edge[0]);
    }
  }

  /** Subdivides and smooths; {@code 4^times} triangles for each. */
  public static TriangleMesh loop(TriangleMesh mesh, int times) {
    TriangleMesh result = mesh;
    for (int i = 0; i < times; i++) {
      result = new Subdivision(result).step();
    }
    return result;
  }

  private TriangleMesh step() {
    for (int i = 0; i < mesh.pointCount(); i++) {
      out.point(moved(i));
    }
    int[] t = mesh.triangles();
    for (int i = 0; i < t.length; i += 3) {
      int ab = middle(t[i], t[i + 1]);
      int bc = middle(t[i + 1], t[i + 2]);
      int ca = middle(t[i + 2], t[i]);
      out.triangle(t[i], ab, ca);
      out.triangle(t[i + 1], bc, ab);
      out.triangle(t[i + 2], ca, bc);
      out.triangle(ab, bc, ca);
    }
    return out.mesh();
  }

  private Vector3d moved(int i) {
    Vector3d point = mesh.point(i);
    Set<Integer> border = alongBorder.get(i);
    if (!border.isEmpty()) {
      // A corner where several borders meet stays where it is.
      return border.size() == 2 ? blend(point, 0.75, border) : point;
    }
    int n = neighbours.get(i).size();
    double beta = n == 3 ? 3.0 / 16 : 3.0 / (8 * n);
    return n == 0 ? point : blend(point, 1 - n * beta, neighbours.get(i));
  }

  /** The point by its weight, and the others by the rest in equal parts. */
  private Vector3d blend(Vector3d point, double weight, Set<Integer> others) {
    point.mul(weight);
    for (int other : others) {
      point.fma((1 - weight) / others.size(), mesh.point(other));
    }
    return point;
  }

  private int middle(int a, int b) {
    return middles.computeIfAbsent(
        undirected(a, b),
        key -> {
          int[] opposite = opposites.get(key);
          int low = Math.min(a, b);
          int high = Math.max(a, b);
          Vector3d sum = mesh.point(low).add(mesh.point(high));
          if (opposite == null || opposite[0] < 0 || opposite[1] < 0) {
            return out.point(sum.mul(0.5));
          }
          sum.mul(3.0 / 8);
          return out.point(
              sum.fma(1.0 / 8, mesh.point(opposite[0])).fma(1.0 / 8, mesh.point(opposite[1])));
        });
  }

  private static long undirected(int a, int b) {
    return MeshMeasures.edge(Math.min(a, b), Math.max(a, b));
  }
}
