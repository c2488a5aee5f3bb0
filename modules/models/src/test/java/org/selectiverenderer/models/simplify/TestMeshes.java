package org.selectiverenderer.models.simplify;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.x3d.tessellate.MeshFactory;

/** Small meshes and measures of meshes. */
final class TestMeshes {
  /** A height above a point of the floor. */
  interface Height {
    double at(double x, double z);
  }

  private TestMeshes() {}

  static Mesh smooth(float[] positions, int[] triangles) {
    return MeshFactory.of(new TriangleMesh(positions, triangles), null, null, null, Math.PI, true);
  }

  static Mesh creased(float[] positions, int[] triangles) {
    return MeshFactory.of(new TriangleMesh(positions, triangles), null, null, null, 0.5, true);
  }

  /** A ball of radius 1 with 2 * rows * columns triangles. */
  static Mesh ball(int rows, int columns) {
    float[] positions = new float[3 * (rows * columns + 2)];
    for (int r = 0; r < rows; r++) {
      double latitude = Math.PI * (r + 1) / (rows + 1);
      for (int c = 0; c < columns; c++) {
        double longitude = 2 * Math.PI * c / columns;
        int at = 3 * (r * columns + c);
        positions[at] = (float) (Math.sin(latitude) * Math.cos(longitude));
        positions[at + 1] = (float) Math.cos(latitude);
        positions[at + 2] = (float) (-Math.sin(latitude) * Math.sin(longitude));
      }
    }
    int top = rows * columns;
    positions[3 * top + 1] = 1;
    positions[3 * top + 4] = -1;
    int[] t = new int[6 * rows * columns];
    int n = 0;
    for (int c = 0; c < columns; c++) {
      int d = (c + 1) % columns;
      n = put(t, n, top, c, d);
      for (int r = 0; r < rows - 1; r++) {
        n = put(t, n, r * columns + c, (r + 1) * columns + c, (r + 1) * columns + d);
        n = put(t, n, r * columns + c, (r + 1) * columns + d, r * columns + d);
      }
      n = put(t, n, top + 1, (rows - 1) * columns + d, (rows - 1) * columns + c);
    }
    return smooth(positions, Arrays.copyOf(t, n));
  }

  /** A ball whose poles are rings of vertices, the lower one of so small a radius. */
  static Mesh ballWithPoleOfMany(int rows, int columns, double radius) {
    float[] positions = new float[3 * (rows + 1) * columns];
    int[] t = new int[6 * rows * columns];
    int n = 0;
    for (int r = 0; r <= rows; r++) {
      double latitude = Math.PI * r / rows;
      double round = r == 0 ? 0 : r == rows ? radius : Math.sin(latitude);
      for (int c = 0; c < columns; c++) {
        double longitude = 2 * Math.PI * c / columns;
        int a = r * columns + c;
        int b = r * columns + (c + 1) % columns;
        positions[3 * a] = (float) (round * Math.cos(longitude));
        positions[3 * a + 1] = (float) Math.cos(latitude);
        positions[3 * a + 2] = (float) (-round * Math.sin(longitude));
        if (r < rows) {
          n = r == 0 ? n : put(t, n, a, a + columns, b);
          n = r == rows - 1 ? n : put(t, n, b, a + columns, b + columns);
        }
      }
    }
    return creased(positions, Arrays.copyOf(t, n));
  }

  /** A cube of side 1, each face cut into cells * cells squares. */
  static Mesh cube(int cells) {
    int perFace = (cells + 1) * (cells + 1);
    float[] positions = new float[18 * perFace];
    int[] triangles = new int[36 * cells * cells];
    int n = 0;
    for (int face = 0; face < 6; face++) {
      int axis = face / 2;
      int side = face % 2;
      for (int i = 0; i <= cells; i++) {
        for (int j = 0; j <= cells; j++) {
          int at = 3 * (face * perFace + i * (cells + 1) + j);
          positions[at + axis] = side;
          positions[at + (axis + 1) % 3] = (float) i / cells;
          positions[at + (axis + 2) % 3] = (float) j / cells;
          if (i < cells && j < cells) {
            int a = face * perFace + i * (cells + 1) + j;
            int b = a + cells + 1;
            n = side == 1 ? put(triangles, n, a, b, b + 1) : put(triangles, n, a, b + 1, b);
            n = side == 1 ? put(triangles, n, a, b + 1, a + 1) : put(triangles, n, a, a + 1, b + 1);
          }
        }
      }
    }
    return creased(positions, triangles);
  }

  /** A field of heights over the square from (x, 0) to (x + 1, 1), facing up. */
  static Mesh field(double x, int cells, Height height, boolean textured) {
    int side = cells + 1;
    float[] positions = new float[3 * side * side];
    float[] texCoords = new float[2 * side * side];
    int[] triangles = new int[6 * cells * cells];
    int n = 0;
    for (int i = 0; i < side; i++) {
      for (int j = 0; j < side; j++) {
        int v = i * side + j;
        positions[3 * v] = (float) (x + (double) i / cells);
        positions[3 * v + 2] = (float) ((double) j / cells);
        positions[3 * v + 1] = (float) height.at(positions[3 * v], positions[3 * v + 2]);
        texCoords[2 * v] = (float) ((double) i / cells);
        texCoords[2 * v + 1] = (float) ((double) j / cells);
        if (i < cells && j < cells) {
          n = put(triangles, n, v, v + 1, v + side);
          n = put(triangles, n, v + 1, v + side + 1, v + side);
        }
      }
    }
    return MeshFactory.of(
        new TriangleMesh(positions, triangles),
        null,
        null,
        textured ? texCoords : null,
        Math.PI,
        true);
  }

  private static int put(int[] triangles, int at, int a, int b, int c) {
    triangles[at] = a;
    triangles[at + 1] = b;
    triangles[at + 2] = c;
    return at + 3;
  }

  /** How many triangles each edge has, edges known by the positions of their ends. */
  static Map<String, Integer> edges(Mesh mesh) {
    Map<String, Integer> edges = new HashMap<>();
    int[] indices = mesh.indices();
    for (int i = 0; i < indices.length; i++) {
      String a = point(mesh, indices[i]);
      String b = point(mesh, indices[i % 3 == 2 ? i - 2 : i + 1]);
      edges.merge(a.compareTo(b) < 0 ? a + b : b + a, 1, Integer::sum);
    }
    return edges;
  }

  static String point(Mesh mesh, int vertex) {
    return Arrays.toString(Arrays.copyOfRange(mesh.positions(), 3 * vertex, 3 * vertex + 3));
  }

  static double volume(Mesh mesh) {
    double six = 0;
    float[] p = mesh.positions();
    for (int i = 0; i < mesh.indices().length; i += 3) {
      int a = 3 * mesh.indices()[i];
      int b = 3 * mesh.indices()[i + 1];
      int c = 3 * mesh.indices()[i + 2];
      six +=
          p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1])
              + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2])
              + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
    }
    return six / 6;
  }

  static double area(Mesh mesh) {
    double area = 0;
    MergedMesh joined = MergedMesh.of(java.util.List.of(mesh));
    for (int t = 0; t < joined.polygons(); t++) {
      area += TriangleAreas.area(joined.vertices(), joined.indices(), t);
    }
    return area;
  }

  /** The mesh with other colours or texture coordinates. */
  static Mesh with(Mesh mesh, float @Nullable [] colors, float @Nullable [] texCoords) {
    return new Mesh(
        mesh.primitive(),
        mesh.positions(),
        mesh.normals(),
        colors,
        texCoords,
        mesh.indices(),
        mesh.solid(),
        mesh.bounds());
  }
}
