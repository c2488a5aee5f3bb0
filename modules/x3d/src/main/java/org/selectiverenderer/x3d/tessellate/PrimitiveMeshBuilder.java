package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;

/** Builds a mesh from vertices with computed positions, normals and texture coordinates. */
final class PrimitiveMeshBuilder {
  private final TriangleMeshBuilder form = new TriangleMeshBuilder();
  private float[] normals = new float[96];
  private float[] texCoords = new float[64];

  /** Adds a vertex and returns its index. */
  int vertex(double x, double y, double z, double nx, double ny, double nz, double s, double t) {
    int vertex = form.point(x, y, z);
    if (3 * vertex == normals.length) {
      normals = Arrays.copyOf(normals, 2 * normals.length);
      texCoords = Arrays.copyOf(texCoords, 2 * texCoords.length);
    }
    normals[3 * vertex] = (float) nx;
    normals[3 * vertex + 1] = (float) ny;
    normals[3 * vertex + 2] = (float) nz;
    texCoords[2 * vertex] = (float) s;
    texCoords[2 * vertex + 1] = (float) t;
    return vertex;
  }

  /** Adds a triangle, counter-clockwise seen from its front. */
  void triangle(int a, int b, int c) {
    form.triangle(a, b, c);
  }

  /** Adds the two triangles of a quadrilateral. */
  void quad(int a, int b, int c, int d) {
    form.quad(a, b, c, d);
  }

  Mesh mesh(boolean solid) {
    TriangleMesh made = form.mesh();
    return new Mesh(
        Mesh.Primitive.TRIANGLES,
        made.positions(),
        Arrays.copyOf(normals, made.positions().length),
        null,
        Arrays.copyOf(texCoords, 2 * made.pointCount()),
        made.triangles(),
        solid,
        Mesh.boundsOf(made.positions(), made.triangles()));
  }

  /** Returns a mesh without triangles. */
  static Mesh empty(boolean solid) {
    return new PrimitiveMeshBuilder().mesh(solid);
  }
}
