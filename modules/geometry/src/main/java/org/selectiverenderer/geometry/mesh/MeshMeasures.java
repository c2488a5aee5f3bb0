package org.selectiverenderer.geometry.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Vector3d;

/** Measures triangle meshes: volume, area, normals, border. */
public final class MeshMeasures {

  private MeshMeasures() {}

  /** Returns the enclosed volume in cubic metres (divergence theorem); negative if inside out. */
  public static double volume(TriangleMesh mesh) {
    double six = 0;
    int[] t = mesh.triangles();
    for (int i = 0; i < t.length; i += 3) {
      Vector3d a = mesh.point(t[i]);
      six += a.dot(mesh.point(t[i + 1]).cross(mesh.point(t[i + 2])));
    }
    return six / 6;
  }

  /** Returns the area of all triangles in square metres. */
  public static double area(TriangleMesh mesh) {
    double sum = 0;
    for (int t = 0; t < mesh.triangleCount(); t++) {
      sum += normal(mesh, t).length() / 2;
    }
    return sum;
  }

  /** Returns the outward normal of a triangle, whose length is twice the triangle's area. */
  public static Vector3d normal(TriangleMesh mesh, int triangle) {
    int[] t = mesh.triangles();
    Vector3d a = mesh.point(t[3 * triangle]);
    Vector3d u = mesh.point(t[3 * triangle + 1]).sub(a);
    Vector3d v = mesh.point(t[3 * triangle + 2]).sub(a);
    return u.cross(v);
  }

  /**
   * Returns the number of directed edges without exactly one opposite edge; 0 for a closed
   * orientable surface.
   */
  public static int openEdges(TriangleMesh mesh) {
    long[] edges = edges(mesh);
    int open = 0;
    for (int i = 0; i < edges.length; i++) {
      boolean repeated = i > 0 && edges[i] == edges[i - 1];
      if (repeated || !contains(edges, edge((int) edges[i], (int) (edges[i] >>> 32)))) {
        open++;
      }
    }
    return open;
  }

  /** Returns the directed edges of all triangles, sorted. */
  private static long[] edges(TriangleMesh mesh) {
    int[] t = mesh.triangles();
    long[] edges = new long[t.length];
    for (int i = 0; i < t.length; i++) {
      edges[i] = edge(t[i], t[i % 3 == 2 ? i - 2 : i + 1]);
    }
    Arrays.sort(edges);
    return edges;
  }

  private static boolean contains(long[] edges, long edge) {
    return Arrays.binarySearch(edges, edge) >= 0;
  }

  /** Returns the directed border edges (from, to), in the order of their triangles. */
  public static List<int[]> border(TriangleMesh mesh) {
    long[] edges = edges(mesh);
    int[] t = mesh.triangles();
    List<int[]> border = new ArrayList<>();
    for (int i = 0; i < t.length; i++) {
      int to = t[i % 3 == 2 ? i - 2 : i + 1];
      if (!contains(edges, edge(to, t[i]))) {
        border.add(new int[] {t[i], to});
      }
    }
    return border;
  }

  /** Packs a directed edge. */
  private static long edge(int from, int to) {
    return (long) from << 32 | to;
  }
}
