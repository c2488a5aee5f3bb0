package org.selectiverenderer.models.simplify;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The parts of a model merged into one array of vertices and one of triangles, so that they are
 * simplified together.
 *
 * @param vertices {@link #STRIDE} floats per vertex: x, y, z; normal; r, g, b, a; s, t; the part's
 *     number. Attributes that a part does not have are 0.
 * @param indices three vertex indices per triangle
 * @param origins index of each vertex in the original model
 */
record MergedMesh(float[] vertices, int[] indices, int[] origins) {
  static final int STRIDE = 13;
  static final int NORMAL = 3;
  static final int COLOR = 6;
  static final int TEX_COORD = 10;
  static final int PART = 12;

  /** As many as an array of their numbers can hold. */
  private static final int MAX_VERTICES = (Integer.MAX_VALUE - 8) / STRIDE - 1;

  /**
   * @throws IllegalArgumentException if a part is not made of triangles, an index is out of range,
   *     or a number is not finite: native code must not get such values
   */
  static MergedMesh of(List<Mesh> parts) {
    long vertexSum = 0;
    long indexSum = 0;
    for (Mesh part : parts) {
      check(part);
      vertexSum += part.vertexCount();
      indexSum += part.indices().length;
    }
    if (vertexSum > MAX_VERTICES || indexSum > Integer.MAX_VALUE - 8) {
      throw new IllegalArgumentException(
          "the model has more than %d vertices, which is the limit".formatted(MAX_VERTICES));
    }
    int vertexCount = (int) vertexSum;
    int indexCount = (int) indexSum;
    float[] vertices = new float[STRIDE * vertexCount];
    int[] indices = new int[indexCount];
    int firstVertex = 0;
    int firstIndex = 0;
    for (int p = 0; p < parts.size(); p++) {
      Mesh part = parts.get(p);
      put(vertices, firstVertex, 0, part.positions(), 3);
      put(vertices, firstVertex, NORMAL, part.normals(), 3);
      put(vertices, firstVertex, COLOR, part.colors(), 4);
      put(vertices, firstVertex, TEX_COORD, part.texCoords(), 2);
      for (int v = firstVertex; v < firstVertex + part.vertexCount(); v++) {
        vertices[STRIDE * v + PART] = p;
      }
      for (int index : part.indices()) {
        indices[firstIndex++] = firstVertex + index;
      }
      firstVertex += part.vertexCount();
    }
    return new MergedMesh(vertices, indices, numbers(vertexCount));
  }

  private static void check(Mesh part) {
    if (part.primitive() != Mesh.Primitive.TRIANGLES || part.indices().length % 3 != 0) {
      throw new IllegalArgumentException("only triangles can be reduced");
    }
    for (int index : part.indices()) {
      if (index < 0 || index >= part.vertexCount()) {
        throw new IllegalArgumentException(
            "a triangle has vertex " + index + ", which does not exist");
      }
    }
    if (wrongLength(part.normals(), part, 3)
        || wrongLength(part.colors(), part, 4)
        || wrongLength(part.texCoords(), part, 2)) {
      throw new IllegalArgumentException("vertices have more or fewer attributes than positions");
    }
    for (float[] values :
        new float[][] {part.positions(), part.normals(), part.colors(), part.texCoords()}) {
      for (int i = 0; values != null && i < values.length; i++) {
        if (!(Math.abs(values[i]) < Float.POSITIVE_INFINITY)) {
          throw new IllegalArgumentException("a vertex has a value that is not a finite number");
        }
      }
    }
  }

  private static boolean wrongLength(float @Nullable [] values, Mesh part, int each) {
    return values != null && values.length != (long) each * part.vertexCount();
  }

  private static void put(
      float[] vertices, int firstVertex, int offset, float @Nullable [] values, int size) {
    if (values == null) {
      return;
    }
    int to = STRIDE * firstVertex + offset;
    for (int from = 0; from < values.length; to += STRIDE) {
      for (int i = 0; i < size; i++) {
        vertices[to + i] = values[from++] + 0.0f; // -0 becomes 0: bits are compared
      }
    }
  }

  int vertexCount() {
    return vertices.length / STRIDE;
  }

  int polygons() {
    return indices.length / 3;
  }

  int part(int vertex) {
    return (int) vertices[STRIDE * vertex + PART];
  }

  /** Returns whether any vertex has a nonzero value in a range of offsets of its record. */
  boolean has(int from, int to) {
    for (int vertex = 0; vertex < vertices.length; vertex += STRIDE) {
      for (int i = vertex + from; i < vertex + to; i++) {
        if (vertices[i] != 0) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns the largest side of the bounding box of the triangles; 0 without triangles. */
  double extent() {
    double largest = 0;
    for (int axis = 0; axis < 3; axis++) {
      float least = Float.POSITIVE_INFINITY;
      float most = Float.NEGATIVE_INFINITY;
      for (int index : indices) {
        float value = vertices[STRIDE * index + axis];
        least = Math.min(least, value);
        most = Math.max(most, value);
      }
      largest = Math.max(largest, (double) most - least);
    }
    return largest;
  }

  /** Returns the same mesh as an original: each vertex is its own origin. */
  MergedMesh asOriginal() {
    return new MergedMesh(vertices, indices, numbers(vertexCount()));
  }

  private static int[] numbers(int count) {
    int[] numbers = new int[count];
    Arrays.setAll(numbers, number -> number);
    return numbers;
  }

  float[] positions() {
    float[] positions = new float[3 * vertexCount()];
    for (int v = 0; v < vertexCount(); v++) {
      System.arraycopy(vertices, STRIDE * v, positions, 3 * v, 3);
    }
    return positions;
  }

  /**
   * Returns the mesh with vertices welded that fall on the same point of a grid with that many
   * steps per unit of length, without triangles that become empty. Many models have vertices that
   * are meant to coincide and differ in the last digit.
   */
  MergedMesh welded(double scale) {
    float[] onGrid = vertices.clone();
    for (int i = 0; i < onGrid.length; i += STRIDE) {
      for (int axis = 0; axis < 3; axis++) {
        onGrid[i + axis] = (float) Math.rint(vertices[i + axis] * scale) + 0.0f;
      }
    }
    int[] first = PositionRemap.first(with(onGrid, indices), false);
    float[] welded = vertices.clone();
    for (int vertex = 0; vertex < first.length; vertex++) {
      System.arraycopy(vertices, STRIDE * first[vertex], welded, STRIDE * vertex, 3);
    }
    return Arrays.equals(welded, vertices) ? this : TriangleAreas.dropEmpty(with(welded, indices));
  }

  /**
   * Returns the mesh with positions clamped to a box and rounded to a grid with that many steps per
   * unit of length, without triangles that become empty.
   */
  MergedMesh rounded(double scale, float[] bounds) {
    float[] rounded = vertices.clone();
    for (int i = 0; i < rounded.length; i += STRIDE) {
      for (int axis = 0; axis < 3; axis++) {
        float inside = Math.max(bounds[axis], Math.min(bounds[axis + 3], vertices[i + axis]));
        rounded[i + axis] = (float) (Math.rint(inside * scale) / scale) + 0.0f;
      }
    }
    return TriangleAreas.dropEmpty(with(rounded, indices)).compact();
  }

  /**
   * Returns the mesh stretched to fill another bounding box, on each axis where the factor is at
   * most {@code largest}; positions are rounded to a grid with {@code scale} steps per unit of
   * length. Returns this mesh if triangles would become empty.
   */
  MergedMesh fitted(float[] box, double largest, double scale) {
    float[] own = Mesh.boundsOf(positions(), indices);
    float[] fitted = vertices.clone();
    for (int axis = 0; axis < 3; axis++) {
      double has = (double) own[axis + 3] - own[axis];
      double wanted = (double) box[axis + 3] - box[axis];
      if (has > 0 && wanted / has <= largest && has / wanted <= largest) {
        for (int i = axis; i < fitted.length; i += STRIDE) {
          double at = box[axis] + (vertices[i] - own[axis]) / has * wanted;
          fitted[i] = (float) (Math.rint(at * scale) / scale) + 0.0f;
        }
      }
    }
    MergedMesh result = with(fitted, indices);
    return TriangleAreas.dropEmpty(result).polygons() == polygons() ? result : this;
  }

  /** Returns a mesh with these triangles and vertices that may have moved. */
  MergedMesh with(float[] moved, int[] triangles) {
    return new MergedMesh(moved, triangles, origins);
  }

  /** Returns the same triangles, without unused vertices. */
  MergedMesh compact() {
    int[] renamed = new int[vertexCount()];
    Arrays.fill(renamed, -1);
    float[] kept = new float[vertices.length];
    int[] keptOrigins = new int[renamed.length];
    int[] renamedIndices = new int[indices.length];
    int count = 0;
    for (int i = 0; i < indices.length; i++) {
      int vertex = indices[i];
      if (renamed[vertex] < 0) {
        System.arraycopy(vertices, STRIDE * vertex, kept, STRIDE * count, STRIDE);
        keptOrigins[count] = origins[vertex];
        renamed[vertex] = count++;
      }
      renamedIndices[i] = renamed[vertex];
    }
    return new MergedMesh(
        Arrays.copyOf(kept, STRIDE * count), renamedIndices, Arrays.copyOf(keptOrigins, count));
  }
}
