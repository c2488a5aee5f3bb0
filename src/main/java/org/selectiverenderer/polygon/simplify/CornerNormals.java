package org.selectiverenderer.polygon.simplify;

import java.util.Arrays;

/**
 * Finds the normal of each corner of a reduced mesh. A vertex on an edge has a normal for each side
 * in the original; when edges have gone, the side that a triangle belongs to may be another than
 * the one its vertex came from, and would be shaded as if bent.
 */
final class CornerNormals {
  /**
   * A normal that has come out so far from its triangle's plane is the wrong side's: 70 degrees.
   */
  private static final double ASTRAY = 0.34;

  /**
   * Normals this near to the plane's shade a facet as flat: 0.08 degrees. On a finely divided round
   * surface they are within a degree or two of it, and still are no facet.
   */
  private static final double FLAT = 0.999_999;

  private final JoinedMesh original;
  private final int[] next;
  private final boolean[] flat;

  CornerNormals(JoinedMesh original) {
    this.original = original;
    this.next = rings(Seams.first(original, true));
    this.flat = flat(original);
  }

  /** Links the vertices of each position to a ring. */
  private static int[] rings(int[] first) {
    int[] next = new int[first.length];
    for (int vertex = 0; vertex < first.length; vertex++) {
      next[vertex] = vertex;
      if (first[vertex] != vertex) {
        next[vertex] = next[first[vertex]];
        next[first[vertex]] = vertex;
      }
    }
    return next;
  }

  /** Which vertices have the normal of all their triangles: those of facets. */
  private static boolean[] flat(JoinedMesh mesh) {
    boolean[] flat = new boolean[mesh.vertexCount()];
    Arrays.fill(flat, true);
    double[] face = new double[3];
    for (int t = 0; t < mesh.polygons(); t++) {
      Areas.normal(mesh.vertices(), mesh.indices(), t, face);
      for (int i = 3 * t; i < 3 * t + 3; i++) {
        int vertex = mesh.indices()[i];
        flat[vertex] &= fit(mesh, vertex, face) > FLAT;
      }
    }
    return flat;
  }

  /**
   * The vertex of the original whose normal a corner takes: the given one's own, another's in its
   * place, or -1 for the normal of the triangle's plane.
   *
   * @param face the unit normal of the corner's triangle
   */
  int source(JoinedMesh reduced, int vertex, double[] face) {
    int own = reduced.origins()[vertex];
    double best = fit(reduced, vertex, face);
    int source = own;
    for (int other = next[own]; best < ASTRAY && other != own; other = next[other]) {
      double fit = fit(original, other, face);
      if (fit > best) {
        source = other;
        best = fit;
      }
    }
    boolean facet = flat[source] && best < FLAT;
    return facet || best < ASTRAY ? -1 : source;
  }

  /** The cosine between a vertex's normal and a triangle's. */
  private static double fit(JoinedMesh mesh, int vertex, double[] face) {
    float[] v = mesh.vertices();
    int at = JoinedMesh.STRIDE * vertex + JoinedMesh.NORMAL;
    double x = v[at];
    double y = v[at + 1];
    double z = v[at + 2];
    double length = Math.sqrt(x * x + y * y + z * z);
    return length > 1e-3 ? (x * face[0] + y * face[1] + z * face[2]) / length : -1;
  }
}
