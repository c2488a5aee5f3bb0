package org.selectiverenderer.x3d.tessellate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.VertexWelder;

/**
 * Builds an indexed mesh from corners by welding: corners with the same point, normal, colour and
 * texture coordinate become one vertex. They are compared first by index, which is fast and finds
 * most of them, then by value, for files that repeat the same point or normal many times.
 */
final class IndexedMeshBuilder {
  /** Vertices of a mesh whose points are kept as the node has them, a few equal ones included. */
  private static final int LARGE = 1024;

  /** The share of equal vertices above which it pays to copy the others. */
  private static final int WORTH_COPYING = 16;

  private final float[] points;
  private final int[] corners;
  private final @Nullable VertexAttribute normals;
  private final @Nullable VertexAttribute colors;
  private final @Nullable VertexAttribute texCoords;
  private final List<VertexAttribute> more;

  // for each vertex its point, and a representative corner
  private int[] vertexPoint = {};
  private int[] vertexCorner = {};
  private int vertexCount;

  /**
   * Creates a welder without further attributes.
   *
   * @param points x, y, z per point
   * @param corners point index per corner
   */
  IndexedMeshBuilder(
      float[] points,
      int[] corners,
      @Nullable VertexAttribute normals,
      @Nullable VertexAttribute colors,
      @Nullable VertexAttribute texCoords) {
    this(points, corners, normals, colors, texCoords, List.of());
  }

  /**
   * Creates a welder.
   *
   * @param more further texture coordinates, then attributes for shader programs
   */
  IndexedMeshBuilder(
      float[] points,
      int[] corners,
      @Nullable VertexAttribute normals,
      @Nullable VertexAttribute colors,
      @Nullable VertexAttribute texCoords,
      List<VertexAttribute> more) {
    this.points = points;
    this.corners = corners;
    this.normals = normals;
    this.colors = colors;
    this.texCoords = texCoords;
    this.more = more;
  }

  /**
   * Returns the mesh of the corners in their order.
   *
   * @param defaultTexCoords whether there are default texture coordinates if there are no others
   */
  Mesh mesh(Mesh.Primitive primitive, boolean solid, boolean defaultTexCoords) {
    int[] indices = byPoint() ? weldPoints() : mostlyUnique() ? keepAll() : weldTuples();
    float[] positions = gather(points, 3, null);
    float[] normal = gather(normals);
    float[] color = gather(colors);
    float[] texCoord = gather(texCoords);
    VertexWelder byValue = new VertexWelder(vertexCount, positions, normal, color, texCoord);
    // few meshes have further attributes, and these hardly ever repeat equal tuples
    int distinct = more.isEmpty() ? byValue.weld() : vertexCount;
    if (distinct < vertexCount && shares(positions, distinct)) {
      byValue.unite(indices);
    } else if (distinct < vertexCount) {
      byValue.rename(indices);
      positions = byValue.compact(positions, 3);
      normal = normal == null ? null : byValue.compact(normal, 3);
      color = color == null ? null : byValue.compact(color, 4);
      texCoord = texCoord == null ? null : byValue.compact(texCoord, 2);
    }
    float[] bounds = bounds(positions);
    List<Mesh.TexCoords> others = new ArrayList<>(more.size());
    for (VertexAttribute other : more) {
      float[] values = gather(other.values(), other.components(), other.ids());
      others.add(new Mesh.TexCoords(other.components(), values, other.name()));
    }
    Mesh mesh =
        new Mesh(primitive, positions, normal, color, texCoord, others, indices, solid, bounds);
    return texCoord == null && defaultTexCoords ? mesh.withDefaultTexCoords() : mesh;
  }

  /**
   * Returns whether the vertices stay where they are, since their positions are the node's own
   * array and a copy without the few that are equal to others would nearly double the memory.
   */
  private boolean shares(float[] positions, int distinct) {
    return positions == points
        && vertexCount >= LARGE
        && vertexCount - distinct < vertexCount / WORTH_COPYING;
  }

  private boolean byPoint() {
    return byPoint(normals)
        && byPoint(colors)
        && byPoint(texCoords)
        && more.stream().allMatch(IndexedMeshBuilder::byPoint);
  }

  private static boolean byPoint(@Nullable VertexAttribute attribute) {
    return attribute == null || attribute.ids() == null;
  }

  /** Welds if all attributes are indexed by point: the points used are the vertices. */
  private int[] weldPoints() {
    int[] vertexOf = new int[points.length / 3];
    for (int point : corners) {
      vertexOf[point] = 1;
    }
    vertexPoint = new int[Math.min(vertexOf.length, corners.length)];
    for (int point = 0; point < vertexOf.length; point++) {
      if (vertexOf[point] != 0) {
        vertexPoint[vertexCount] = point;
        vertexOf[point] = vertexCount++;
      }
    }
    int[] indices = new int[corners.length];
    for (int i = 0; i < indices.length; i++) {
      indices[i] = vertexOf[corners[i]];
    }
    return indices;
  }

  /** Returns whether there is about one normal per triangle, so that few corners share one. */
  private boolean mostlyUnique() {
    return normals != null && normals.ids() != null && 3 * normals.count() >= corners.length;
  }

  /** Makes each corner a vertex, to be welded by value only. */
  private int[] keepAll() {
    int[] indices = IndexStreamRanges.identity(corners.length);
    vertexPoint = corners;
    vertexCorner = indices.clone();
    vertexCount = corners.length;
    return indices;
  }

  private int[] weldTuples() {
    int[] indices = new int[corners.length];
    vertexPoint = new int[Math.max(16, corners.length / 4)];
    vertexCorner = new int[vertexPoint.length];
    int[] table = new int[Integer.highestOneBit(vertexPoint.length) * 4];
    for (int corner = 0; corner < corners.length; corner++) {
      if (2 * vertexCount >= table.length) {
        table = grow(table);
      }
      int mask = table.length - 1;
      int slot = hash(corner) & mask;
      while (table[slot] != 0 && !same(vertexCorner[table[slot] - 1], corner)) {
        slot = (slot + 1) & mask;
      }
      if (table[slot] == 0) {
        table[slot] = add(corner) + 1;
      }
      indices[corner] = table[slot] - 1;
    }
    return indices;
  }

  private int add(int corner) {
    if (vertexCount == vertexCorner.length) {
      vertexPoint = Arrays.copyOf(vertexPoint, 2 * vertexCount);
      vertexCorner = Arrays.copyOf(vertexCorner, 2 * vertexCount);
    }
    vertexPoint[vertexCount] = corners[corner];
    vertexCorner[vertexCount] = corner;
    return vertexCount++;
  }

  private int[] grow(int[] table) {
    int[] larger = new int[2 * table.length];
    int mask = larger.length - 1;
    for (int vertex = 0; vertex < vertexCount; vertex++) {
      int slot = hash(vertexCorner[vertex]) & mask;
      while (larger[slot] != 0) {
        slot = (slot + 1) & mask;
      }
      larger[slot] = vertex + 1;
    }
    return larger;
  }

  private int hash(int corner) {
    int h = corners[corner];
    h = h * 31 + id(normals, corner);
    h = h * 31 + id(colors, corner);
    h = h * 31 + id(texCoords, corner);
    for (VertexAttribute other : more) {
      h = h * 31 + id(other, corner);
    }
    h *= 0x9E3779B1;
    return h ^ h >>> 15;
  }

  private boolean same(int a, int b) {
    return corners[a] == corners[b]
        && id(normals, a) == id(normals, b)
        && id(colors, a) == id(colors, b)
        && id(texCoords, a) == id(texCoords, b)
        && sameMore(a, b);
  }

  private boolean sameMore(int a, int b) {
    for (VertexAttribute other : more) {
      if (id(other, a) != id(other, b)) {
        return false;
      }
    }
    return true;
  }

  private static int id(@Nullable VertexAttribute attribute, int corner) {
    return attribute == null || attribute.ids() == null ? 0 : attribute.ids()[corner];
  }

  private float @Nullable [] gather(@Nullable VertexAttribute attribute) {
    return attribute == null
        ? null
        : gather(attribute.values(), attribute.components(), attribute.ids());
  }

  /** Returns the tuples of the vertices in order; the given array itself if it is equal. */
  private float[] gather(float[] values, int components, int @Nullable [] ids) {
    if (ids == null
        && values.length == components * vertexCount
        && (vertexCount == 0 || vertexPoint[vertexCount - 1] == vertexCount - 1)
        && byPoint()) {
      return values;
    }
    float[] gathered = new float[components * vertexCount];
    for (int vertex = 0, to = 0; vertex < vertexCount; vertex++) {
      int from = components * (ids == null ? vertexPoint[vertex] : ids[vertexCorner[vertex]]);
      for (int i = 0; i < components; i++) {
        gathered[to++] = values[from + i];
      }
    }
    return gathered;
  }

  private static float[] bounds(float[] positions) {
    float[] b = Mesh.boundsOf(positions, new int[0]);
    for (int axis = 0; axis < 3; axis++) {
      // comparisons are five times as fast as Math.min, which handles NaN
      float min = b[axis];
      float max = b[axis + 3];
      for (int i = axis; i < positions.length; i += 3) {
        float value = positions[i];
        min = value < min ? value : min;
        max = value > max ? value : max;
      }
      b[axis] = min;
      b[axis + 3] = max;
    }
    return b;
  }
}
