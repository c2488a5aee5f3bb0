package org.selectiverenderer.models.simplify;

import java.util.Arrays;

/**
 * Selects the normal of each corner of a reduced mesh. A vertex on a crease has a normal for each
 * side in the original; after edge collapses, a triangle may be on another side than the one its
 * vertex came from, and would be shaded wrongly with that normal.
 */
final class CornerNormals {
  /**
   * A normal that deviates from its triangle's normal by more than this (as a cosine; 70 degrees)
   * belongs to the wrong side.
   */
  private static final double ASTRAY = 0.34;

  /**
   * Normals this near to the triangle's normal (as a cosine; 0.08 degrees) mark a flat facet. On a
   * finely divided curved surface they deviate by a degree or two.
   */
  private static final double FLAT = 0.999_999;

  private final MergedMesh original;
  private final int[] next;
  private final boolean[] flat;

  CornerNormals(MergedMesh original) {
    this.original = original;
    this.next = rings(PositionRemap.first(original, true));
    this.flat = flat(original);
  }

  /** Links the vertices of each position to a circular list. */
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

  /**
   * Returns which vertices have the normal of all their triangles, that is, belong to flat facets.
   */
  private static boolean[] flat(MergedMesh mesh) {
    boolean[] flat = new boolean[mesh.vertexCount()];
    Arrays.fill(flat, true);
    double[] face = new double[3];
    for (int t = 0; t < mesh.polygons(); t++) {
      TriangleAreas.normal(mesh.vertices(), mesh.indices(), t, face);
      for (int i = 3 * t; i < 3 * t + 3; i++) {
        int vertex = mesh.indices()[i];
        flat[vertex] &= fit(mesh, vertex, face) > FLAT;
      }
    }
    return flat;
  }

  /**
   * Returns the vertex of the original whose normal a corner takes: the given one, another one in
   * the same position, or -1 for the normal of the triangle.
   *
   * @param face the unit normal of the corner's triangle
   */
  int source(MergedMesh reduced, int vertex, double[] face) {
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

  /** Returns the cosine of the angle between a vertex's normal and a triangle's normal. */
  private static double fit(MergedMesh mesh, int vertex, double[] face) {
    float[] v = mesh.vertices();
    int at = MergedMesh.STRIDE * vertex + MergedMesh.NORMAL;
    double x = v[at];
    double y = v[at + 1];
    double z = v[at + 2];
    double length = Math.sqrt(x * x + y * y + z * z);
    return length > 1e-3 ? (x * face[0] + y * face[1] + z * face[2]) / length : -1;
  }
}
