package org.selectiverenderer.render.lighting;

import java.util.Arrays;
import org.joml.Matrix3d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The vertices of a mesh under refinement, to which the midpoints of edges are added. All
 * attributes of a midpoint are the means of the ends'; normals are normalised again.
 */
final class MidpointVertexBuffer {
  private final Mesh source;
  private final Matrix4dc world;
  private final Matrix3d normals;
  private final Vector3d p = new Vector3d();
  private final Vector3d n = new Vector3d();
  private float[] positions;
  private float[] normal;
  private float @Nullable [] colors;
  private float @Nullable [] texCoords;
  private int count;

  // World coordinates: position x, y, z, unit normal x, y, z.
  private double[] placed;

  MidpointVertexBuffer(Mesh source, float[] sourceNormals, Matrix4dc world) {
    this.source = source;
    this.world = world;
    normals = world.normal(new Matrix3d());
    // Copied only when vertices are added, because most meshes turn out to be fine enough.
    positions = source.positions();
    normal = sourceNormals;
    colors = source.colors();
    texCoords = source.texCoords();
    placed = new double[6 * source.vertexCount()];
    for (int i = 0; i < source.vertexCount(); i++) {
      place(i);
    }
    count = source.vertexCount();
  }

  int count() {
    return count;
  }

  /** Returns positions and normals in the world: six numbers from {@code 6 * vertex}. */
  double[] placed() {
    return placed;
  }

  float[] positions() {
    return positions;
  }

  /** Returns the length of an edge in the mesh's coordinates. */
  double length(int a, int b) {
    double x = positions[3 * b] - positions[3 * a];
    double y = positions[3 * b + 1] - positions[3 * a + 1];
    double z = positions[3 * b + 2] - positions[3 * a + 2];
    return Math.sqrt(x * x + y * y + z * z);
  }

  private void place(int v) {
    p.set(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
    n.set(normal[3 * v], normal[3 * v + 1], normal[3 * v + 2]);
    world.transformPosition(p);
    normals.transform(n);
    if (n.lengthSquared() > 0) {
      n.normalize();
    }
    placed[6 * v] = p.x;
    placed[6 * v + 1] = p.y;
    placed[6 * v + 2] = p.z;
    placed[6 * v + 3] = n.x;
    placed[6 * v + 4] = n.y;
    placed[6 * v + 5] = n.z;
  }

  /** Enlarges the arrays for more vertices. */
  void reserve(int more) {
    int all = count + more;
    positions = Arrays.copyOf(positions, 3 * all);
    normal = Arrays.copyOf(normal, 3 * all);
    colors = colors == null ? null : Arrays.copyOf(colors, 4 * all);
    texCoords = texCoords == null ? null : Arrays.copyOf(texCoords, 2 * all);
    placed = Arrays.copyOf(placed, 6 * all);
  }

  /** Adds the midpoint of two vertices, for which space is reserved; returns its number. */
  int middle(int a, int b) {
    int v = count++;
    halve(positions, 3, a, b, v);
    halve(normal, 3, a, b, v);
    unit(v);
    halve(colors, 4, a, b, v);
    halve(texCoords, 2, a, b, v);
    place(v);
    return v;
  }

  private static void halve(float @Nullable [] values, int size, int a, int b, int to) {
    for (int i = 0; values != null && i < size; i++) {
      values[size * to + i] = (values[size * a + i] + values[size * b + i]) / 2;
    }
  }

  private void unit(int v) {
    double x = normal[3 * v];
    double y = normal[3 * v + 1];
    double z = normal[3 * v + 2];
    double length = Math.sqrt(x * x + y * y + z * z);
    double scale = length > 0 ? 1 / length : 0;
    normal[3 * v] = (float) (x * scale);
    normal[3 * v + 1] = (float) (y * scale);
    normal[3 * v + 2] = (float) (z * scale);
  }

  /** Returns the mesh of these vertices; its surface and so its bounds are the source's. */
  Mesh mesh(int[] indices) {
    return new Mesh(
        source.primitive(),
        positions,
        normal,
        colors,
        texCoords,
        indices,
        source.solid(),
        source.bounds());
  }
}
