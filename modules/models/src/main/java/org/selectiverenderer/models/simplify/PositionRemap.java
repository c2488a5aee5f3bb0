package org.selectiverenderer.models.simplify;

import java.util.Arrays;

/**
 * Maps vertices that share a position to one of them (the position remap of meshoptimizer), counts
 * positions, and finds seams.
 */
final class PositionRemap {
  private PositionRemap() {}

  /**
   * Maps each vertex to the first vertex in the same position.
   *
   * @param byPart whether equal positions in two parts count as two
   * @return for each vertex the first vertex in the same position
   */
  static int[] first(MergedMesh mesh, boolean byPart) {
    int count = mesh.vertexCount();
    float[] v = mesh.vertices();
    int[] first = new int[count];
    int[] table = new int[Integer.highestOneBit(Math.max(8, count)) * 4];
    int mask = table.length - 1;
    for (int vertex = 0; vertex < count; vertex++) {
      int slot = hash(v, MergedMesh.STRIDE * vertex) & mask;
      while (table[slot] != 0 && !same(v, table[slot] - 1, vertex, byPart)) {
        slot = (slot + 1) & mask;
      }
      if (table[slot] == 0) {
        table[slot] = vertex + 1;
      }
      first[vertex] = table[slot] - 1;
    }
    return first;
  }

  private static int hash(float[] v, int at) {
    int hash = 0;
    for (int i = at; i < at + 3; i++) {
      hash = (hash ^ Float.floatToRawIntBits(v[i])) * 0x9E3779B1;
      hash ^= hash >>> 15;
    }
    return hash;
  }

  private static boolean same(float[] v, int a, int b, boolean byPart) {
    int i = MergedMesh.STRIDE * a;
    int j = MergedMesh.STRIDE * b;
    return v[i] == v[j]
        && v[i + 1] == v[j + 1]
        && v[i + 2] == v[j + 2]
        && (!byPart || v[i + MergedMesh.PART] == v[j + MergedMesh.PART]);
  }

  /** Returns the number of distinct positions that triangles use, summed over the parts. */
  static int positions(MergedMesh mesh) {
    int[] first = first(mesh, true);
    boolean[] used = new boolean[first.length];
    int count = 0;
    for (int index : mesh.indices()) {
      if (!used[first[index]]) {
        used[first[index]] = true;
        count++;
      }
    }
    return count;
  }

  /**
   * Marks the vertices on visible seams, where part, colour or texture coordinate jumps: those that
   * share a position with a vertex that differs in more than the normal.
   */
  static boolean[] visible(MergedMesh mesh) {
    int[] first = first(mesh, false);
    boolean[] seam = new boolean[first.length];
    for (int vertex = 0; vertex < first.length; vertex++) {
      if (jumps(mesh.vertices(), first[vertex], vertex)) {
        seam[first[vertex]] = true;
      }
    }
    for (int vertex = 0; vertex < first.length; vertex++) {
      seam[vertex] = seam[first[vertex]];
    }
    return seam;
  }

  private static boolean jumps(float[] v, int a, int b) {
    int from = MergedMesh.STRIDE * a;
    int other = MergedMesh.STRIDE * b;
    return !Arrays.equals(
        v,
        from + MergedMesh.COLOR,
        from + MergedMesh.STRIDE,
        v,
        other + MergedMesh.COLOR,
        other + MergedMesh.STRIDE);
  }
}
