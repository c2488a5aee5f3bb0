package org.selectiverenderer.models.simplify;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Builds the mesh of one part from its triangles of the reduced model. */
final class PartMeshBuilder {
  private final Mesh part;
  private final MergedMesh original;
  private final MergedMesh reduced;
  private final CornerNormals corners;
  private final double[] face = new double[3];

  // Vertices built so far: those with their own normal, and others.
  private final int[] own;
  private final Map<Long, Integer> others = new HashMap<>();

  private float[] positions = new float[48];
  private float[] normals = new float[48];
  private float[] colors = new float[64];
  private float[] texCoords = new float[32];
  private int vertexCount;

  /**
   * @param own scratch array with -1 for each vertex; it is restored afterwards
   */
  PartMeshBuilder(
      Mesh part, MergedMesh original, MergedMesh reduced, CornerNormals corners, int[] own) {
    this.part = part;
    this.original = original;
    this.reduced = reduced;
    this.corners = corners;
    this.own = own;
  }

  /**
   * @param triangles indices of the part's triangles
   */
  Mesh mesh(int[] triangles) {
    int[] indices = new int[3 * triangles.length];
    int count = 0;
    for (int triangle : triangles) {
      TriangleAreas.normal(reduced.vertices(), reduced.indices(), triangle, face);
      for (int i = 3 * triangle; i < 3 * triangle + 3; i++) {
        indices[count++] = vertex(reduced.indices()[i], triangle);
      }
    }
    for (int triangle : triangles) {
      own[reduced.indices()[3 * triangle]] = -1;
      own[reduced.indices()[3 * triangle + 1]] = -1;
      own[reduced.indices()[3 * triangle + 2]] = -1;
    }
    float[] finalPositions = Arrays.copyOf(positions, 3 * vertexCount);
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        finalPositions,
        trimmed(normals, part.normals(), 3),
        trimmed(colors, part.colors(), 4),
        trimmed(texCoords, part.texCoords(), 2),
        indices,
        part.solid(),
        Mesh.boundsOf(finalPositions, indices));
  }

  private float @Nullable [] trimmed(float[] values, float @Nullable [] had, int size) {
    return had == null ? null : Arrays.copyOf(values, size * vertexCount);
  }

  private int vertex(int vertex, int triangle) {
    int source = part.normals() == null ? 0 : corners.source(reduced, vertex, face);
    if (source == reduced.origins()[vertex] || part.normals() == null) {
      if (own[vertex] < 0) {
        own[vertex] = add(vertex, source);
      }
      return own[vertex];
    }
    // Source -1 stands for the normal of the triangle.
    long key = (long) vertex << 32 | (source < 0 ? 0x80000000L | triangle : source);
    return others.computeIfAbsent(key, unused -> add(vertex, source));
  }

  private int add(int vertex, int source) {
    if (3 * vertexCount == positions.length) {
      positions = Arrays.copyOf(positions, 2 * positions.length);
      normals = Arrays.copyOf(normals, 2 * normals.length);
      colors = Arrays.copyOf(colors, 2 * colors.length);
      texCoords = Arrays.copyOf(texCoords, 2 * texCoords.length);
    }
    float[] v = reduced.vertices();
    int from = MergedMesh.STRIDE * vertex;
    System.arraycopy(v, from, positions, 3 * vertexCount, 3);
    System.arraycopy(v, from + MergedMesh.TEX_COORD, texCoords, 2 * vertexCount, 2);
    for (int i = 0; i < 4; i++) {
      float color = v[from + MergedMesh.COLOR + i];
      colors[4 * vertexCount + i] = Math.max(0, Math.min(1, color));
    }
    boolean own = source == reduced.origins()[vertex];
    for (int i = 0; i < 3; i++) {
      normals[3 * vertexCount + i] =
          source < 0
              ? (float) face[i]
              : own
                  ? v[from + MergedMesh.NORMAL + i]
                  : original.vertices()[MergedMesh.STRIDE * source + MergedMesh.NORMAL + i];
    }
    normalise(3 * vertexCount);
    return vertexCount++;
  }

  private void normalise(int at) {
    double x = normals[at];
    double y = normals[at + 1];
    double z = normals[at + 2];
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0) {
      normals[at] = (float) (x / length);
      normals[at + 1] = (float) (y / length);
      normals[at + 2] = (float) (z / length);
    }
  }
}
